// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Eigen-analysis of one symmetric 3x3 matrix a lane, in double. Included once per
// instruction set, so it has a guard that toggles.

#if defined(LINELET_GRID_EIGEN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_EIGEN_INL
#undef LINELET_GRID_EIGEN_INL
#else
#define LINELET_GRID_EIGEN_INL
#endif

#include <hwy/highway.h>

#include "sweep_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<double>;
using VD = hn::Vec<D>;

/** \brief A vector in space a lane. */
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

/** \brief Puts a, b in ascending order and their columns along. */
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
 * digits, which closed forms lose. */
void
eigen(const EigenBatch& batch)
{
  const D d;
  const VD zero = hn::Zero(d), one = hn::Set(d, 1);
  for (std::size_t i = 0; i < batch.count; i += hn::Lanes(d)) {
    VD xx = hn::LoadU(d, batch.tensor[0] + i), xy = hn::LoadU(d, batch.tensor[1] + i),
       xz = hn::LoadU(d, batch.tensor[2] + i), yy = hn::LoadU(d, batch.tensor[3] + i),
       yz = hn::LoadU(d, batch.tensor[4] + i), zz = hn::LoadU(d, batch.tensor[5] + i);
    Column u{one, zero, zero}, v{zero, one, zero}, w{zero, zero, one};
    // Convergence is quadratic; the sixth turn is never needed for what rounding shows.
    constexpr int most_turns = 6;
    const VD scale = hn::Add(xx, hn::Add(yy, zz));
    const VD negligible = hn::Mul(scale, hn::Set(d, 1e-17));
    for (int turn = 0; turn < most_turns; ++turn) {
      jacobiRotation(xx, yy, xy, xz, yz, u, v);
      jacobiRotation(xx, zz, xz, xy, yz, u, w);
      jacobiRotation(yy, zz, yz, xy, xz, v, w);
      const VD rest = hn::Add(hn::Abs(xy), hn::Add(hn::Abs(xz), hn::Abs(yz)));
      if (hn::AllFalse(d, hn::Gt(rest, negligible)))
        break;
    }
    order(xx, yy, u, v);
    order(yy, zz, v, w);
    order(xx, yy, u, v);
    orient(u);
    orient(w);
    hn::StoreU(hn::Max(xx, zero), d, batch.values[0] + i);
    hn::StoreU(hn::Max(yy, zero), d, batch.values[1] + i);
    hn::StoreU(hn::Max(zz, zero), d, batch.values[2] + i);
    hn::StoreU(w.x, d, batch.major[0] + i);
    hn::StoreU(w.y, d, batch.major[1] + i);
    hn::StoreU(w.z, d, batch.major[2] + i);
    hn::StoreU(u.x, d, batch.normal[0] + i);
    hn::StoreU(u.y, d, batch.normal[1] + i);
    hn::StoreU(u.z, d, batch.normal[2] + i);
  }
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
