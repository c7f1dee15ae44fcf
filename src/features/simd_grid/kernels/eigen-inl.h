// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Eigen-analysis of one symmetric 3x3 matrix per lane, in double. Included once per
// instruction set, so it has a guard that toggles.

#if defined(LINELET_GRID_EIGEN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_EIGEN_INL
#undef LINELET_GRID_EIGEN_INL
#else
#define LINELET_GRID_EIGEN_INL
#endif

#include <hwy/highway.h>

#include "lane_moments-inl.h"
#include "sweep_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

/** \brief A vector in space per lane. */
struct Column {
  VD x, y, z;
};

/** \brief Turns columns p and q of the rotation so far, and the entries of the matrix,
 * by the angle that makes its entry (p, q) zero; r is the third axis. */
HWY_INLINE void
jacobiRotation(VD& app, VD& aqq, VD& apq, VD& apr, VD& aqr, Column& p, Column& q)
{
  const D d;
  const VD zero = hn::Zero(d);
  // tan = 2 apq / (diff +- sqrt(diff^2 + 4 apq^2)), the smaller of both angles.
  const VD diff = hn::Sub(aqq, app), twice = hn::Add(apq, apq);
  const VD root = hn::Sqrt(hn::MulAdd(diff, diff, hn::Mul(twice, twice)));
  const VD below = hn::Add(diff, hn::CopySign(root, diff));
  const VD tangent = hn::IfThenElseZero(hn::Ne(below, zero), hn::Div(twice, below));
  const VD one = hn::Set(d, 1);
  const VD c = hn::Div(one, hn::Sqrt(hn::MulAdd(tangent, tangent, one)));
  const VD s = hn::Mul(tangent, c);
  app = hn::NegMulAdd(tangent, apq, app);
  aqq = hn::MulAdd(tangent, apq, aqq);
  apq = zero;
  const auto turn = [&](VD& u, VD& v) HWY_ATTR {
    const VD old = u;
    u = hn::NegMulAdd(s, v, hn::Mul(c, u));
    v = hn::MulAdd(s, old, hn::Mul(c, v));
  };
  turn(apr, aqr);
  turn(p.x, q.x);
  turn(p.y, q.y);
  turn(p.z, q.z);
}

/** \brief Puts a and b in ascending order, and their columns with them. */
HWY_INLINE void
order(VD& a, VD& b, Column& u, Column& v)
{
  const auto swap = hn::Gt(a, b);
  const auto exchange = [&](VD& s, VD& t) HWY_ATTR {
    const VD old = s;
    s = hn::IfThenElse(swap, t, s);
    t = hn::IfThenElse(swap, old, t);
  };
  exchange(a, b);
  exchange(u.x, v.x);
  exchange(u.y, v.y);
  exchange(u.z, v.z);
}

/** \brief Makes the component of largest magnitude positive, the first of equals. */
HWY_INLINE void
orient(Column& c)
{
  const D d;
  const VD ax = hn::Abs(c.x), ay = hn::Abs(c.y), az = hn::Abs(c.z);
  VD largest = hn::IfThenElse(hn::Gt(ay, ax), c.y, c.x);
  largest = hn::IfThenElse(hn::Gt(az, hn::Max(ax, ay)), c.z, largest);
  const VD sign = hn::CopySign(hn::Set(d, 1), largest);
  c.x = hn::Mul(c.x, sign);
  c.y = hn::Mul(c.y, sign);
  c.z = hn::Mul(c.z, sign);
}

/** \brief Cyclic Jacobi: keeps the small eigenvalues of wire-like tensors to their last
 * digits, which closed forms lose. In the end xx <= yy <= zz are the eigenvalues over
 * the trace, not negative, u and w the eigenvectors of the first and the last. */
struct EigenLanes {
  VD xx, xy, xz, yy, yz, zz;
  VD trace;
  Column u, v, w;

  HWY_INLINE void
  begin()
  {
    const VD zero = hn::Zero(D()), one = hn::Set(D(), 1);
    trace = hn::Add(xx, hn::Add(yy, zz));
    const VD inverse = hn::IfThenElseZero(hn::Gt(trace, zero), hn::Div(one, trace));
    for (VD* entry : {&xx, &xy, &xz, &yy, &yz, &zz})
      *entry = hn::Mul(*entry, inverse);
    u = {one, zero, zero};
    v = {zero, one, zero};
    w = {zero, zero, one};
  }

  /** \brief Rotates about all axes.
   * \return whether the off-diagonal rest still matters: eigenvalues are off by its
   * square */
  HWY_INLINE bool
  turn()
  {
    const D d;
    jacobiRotation(xx, yy, xy, xz, yz, u, v);
    jacobiRotation(xx, zz, xz, xy, yz, u, w);
    jacobiRotation(yy, zz, yz, xy, xz, v, w);
    const VD rest = hn::Add(hn::Abs(xy), hn::Add(hn::Abs(xz), hn::Abs(yz)));
    return !hn::AllFalse(d, hn::Gt(rest, hn::Set(d, 1e-15)));
  }

  HWY_INLINE void
  end()
  {
    order(xx, yy, u, v);
    order(yy, zz, v, w);
    order(xx, yy, u, v);
    orient(u);
    orient(w);
    const VD zero = hn::Zero(D());
    xx = hn::Max(xx, zero);
    yy = hn::Max(yy, zero);
  }
};

/** \brief Two vectors at once: the steps of one hide the latency of the other. */
HWY_INLINE void
analyze(EigenLanes& a, EigenLanes& b)
{
  // Convergence is quadratic; a sixth turn never changes more than rounding does.
  constexpr int most_turns = 6;
  a.begin();
  b.begin();
  for (int turn = 0; turn < most_turns; ++turn) {
    const bool more = a.turn();
    if (!(b.turn() || more))
      break;
  }
  a.end();
  b.end();
}

void
eigen(const EigenBatch& batch)
{
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t i = 0; i < batch.count; i += 2 * lanes) {
    EigenLanes pair[2];
    for (std::size_t k = 0; k < 2; ++k) {
      const auto entry = [&](std::size_t e) HWY_ATTR {
        return hn::LoadU(d, batch.tensor[e] + i + k * lanes);
      };
      pair[k].xx = entry(0);
      pair[k].xy = entry(1);
      pair[k].xz = entry(2);
      pair[k].yy = entry(3);
      pair[k].yz = entry(4);
      pair[k].zz = entry(5);
    }
    analyze(pair[0], pair[1]);
    for (std::size_t k = 0; k < 2; ++k) {
      const EigenLanes& e = pair[k];
      const auto put = [&](VD value, double* to)
                           HWY_ATTR { hn::StoreU(value, d, to + i + k * lanes); };
      put(hn::Mul(e.xx, e.trace), batch.values[0]);
      put(hn::Mul(e.yy, e.trace), batch.values[1]);
      put(hn::Mul(e.zz, e.trace), batch.values[2]);
      put(e.w.x, batch.major[0]);
      put(e.w.y, batch.major[1]);
      put(e.w.z, batch.major[2]);
      put(e.u.x, batch.normal[0]);
      put(e.u.y, batch.normal[1]);
      put(e.u.z, batch.normal[2]);
    }
  }
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
