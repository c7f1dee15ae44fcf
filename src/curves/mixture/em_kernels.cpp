// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "em_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "curves/mixture/em_kernels.cpp"
#include <hwy/foreach_target.h> // includes this file once per instruction set

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include "quick_exp-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, EdgePoints::padding>;
using V = hn::Vec<D>;

// Shares below this one are left out.
constexpr double least_share = 1e-4;

HWY_INLINE V
constant(double value)
{
  return hn::Set(D(), value);
}

/** \brief exp(-z (1.5976 + 0.07056 z^2)), clamped to where its square is finite: the
 * normal distribution function at z is 1 / (1 + this), to 2e-4. */
HWY_INLINE V
normalOdds(V z)
{
  const V slope = hn::MulAdd(hn::Mul(z, z), constant(-0.07056), constant(-1.5976));
  const V exponent = hn::Min(hn::Max(hn::Mul(z, slope), constant(-300)), constant(300));
  return quickExp(D(), exponent);
}

/** \brief Points seen from an edge. */
class Seen {
public:
  explicit Seen(const EdgeShape& edge)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      from_[k] = constant(edge.from[k]);
      direction_[k] = constant(edge.direction[k]);
    }
  }

  /** \brief Places along the edge and squared distances from its line. */
  HWY_INLINE void
  at(V x, V y, V z, V& place, V& off) const
  {
    x = hn::Sub(x, from_[0]);
    y = hn::Sub(y, from_[1]);
    z = hn::Sub(z, from_[2]);
    place = hn::MulAdd(
        x, direction_[0], hn::MulAdd(y, direction_[1], hn::Mul(z, direction_[2])));
    const V squared = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
    off = hn::Max(hn::Zero(D()), hn::NegMulAdd(place, place, squared));
  }

private:
  V from_[3], direction_[3];
};

void
densities(const EdgeShape& edge, const EdgePoints& points, double* density)
{
  const D d;
  const Seen seen(edge);
  const V factor = constant(edge.factor), least = constant(-700);
  const V half_variance = constant(-0.5 / edge.variance);
  const V half_along =
      constant(-0.5 / (edge.variance + edge.length * edge.length / 12));
  const V length = constant(edge.length), middle = constant(0.5 * edge.length);
  const V inverse_noise = hn::Div(constant(1), hn::Sqrt(constant(edge.variance)));
  for (std::size_t k = 0; k < points.count; k += hn::Lanes(d)) {
    V place, off;
    seen.at(hn::LoadU(d, points.x + k),
            hn::LoadU(d, points.y + k),
            hn::LoadU(d, points.z + k),
            place,
            off);
    V exponent = hn::Mul(off, half_variance);
    V value = factor;
    if (edge.is_short) {
      const V t = hn::Sub(place, middle);
      exponent = hn::MulAdd(hn::Mul(t, t), half_along, exponent);
    }
    else {
      const V before = normalOdds(hn::Mul(hn::Sub(length, place), inverse_noise));
      const V after = normalOdds(hn::Neg(hn::Mul(place, inverse_noise)));
      const V one = constant(1);
      const V within = hn::Div(hn::Sub(after, before),
                               hn::Mul(hn::Add(one, before), hn::Add(one, after)));
      value = hn::Mul(factor, within);
    }
    value = hn::Mul(value, quickExp(d, hn::Max(exponent, least)));
    hn::StoreU(value, d, density + k);
  }
}

EdgeSums
sums(const EdgeShape& edge,
     const EdgePoints& points,
     const double* share,
     bool front,
     bool back)
{
  const D d;
  const Seen seen(edge);
  const V zero = hn::Zero(d), lanes = hn::Iota(d, 0);
  // Where on the edge the point came from: uniform on the edge, times normal around the
  // point's own place.
  const double middle_weight = 12 / (edge.length * edge.length);
  const double spread = 1 / (1 / edge.variance + middle_weight);
  const V slope = constant(spread / edge.variance);
  const V offset = constant(0.5 * spread * edge.length * middle_weight);
  const V length = constant(edge.length), inverse_length = constant(1 / edge.length);
  V all = zero, square = zero, aa = zero, ab = zero, bb = zero;
  V moved_a = zero, moved_b = zero;
  V a[3] = {zero, zero, zero}, b[3] = {zero, zero, zero};
  for (std::size_t k = 0; k < points.count; k += hn::Lanes(d)) {
    const V rest = constant(static_cast<double>(points.count - k));
    V r = hn::LoadU(d, share + k);
    r = hn::IfThenElseZero(
        hn::And(hn::Ge(r, constant(least_share)), hn::Lt(lanes, rest)), r);
    const V at[3] = {hn::LoadU(d, points.x + k),
                     hn::LoadU(d, points.y + k),
                     hn::LoadU(d, points.z + k)};
    V place, off;
    seen.at(at[0], at[1], at[2], place, off);
    const V on = hn::Min(hn::Max(hn::MulAdd(slope, place, offset), zero), length);
    // Along the curve, points pull only on its ends.
    V move = hn::Sub(place, on);
    if (front)
      move = hn::IfThenElse(hn::Lt(place, zero), zero, move);
    if (back)
      move = hn::IfThenElse(hn::Gt(place, length), zero, move);
    const V t = hn::Mul(on, inverse_length);
    const V to_b = hn::Mul(r, t), to_a = hn::Sub(r, to_b);
    all = hn::Add(all, r);
    square = hn::MulAdd(r, off, square);
    bb = hn::MulAdd(to_b, t, bb);
    ab = hn::MulAdd(to_a, t, ab);
    aa = hn::Add(aa, hn::NegMulAdd(to_a, t, to_a));
    moved_a = hn::MulAdd(to_a, move, moved_a);
    moved_b = hn::MulAdd(to_b, move, moved_b);
    for (int axis = 0; axis < 3; ++axis) {
      a[axis] = hn::MulAdd(to_a, at[axis], a[axis]);
      b[axis] = hn::MulAdd(to_b, at[axis], b[axis]);
    }
  }
  const auto total = [&](V v) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(d, v)); };
  EdgeSums result;
  result.share = total(all);
  result.square = total(square);
  result.aa = total(aa);
  result.ab = total(ab);
  result.bb = total(bb);
  const double back_a = total(moved_a), back_b = total(moved_b);
  for (int axis = 0; axis < 3; ++axis) {
    result.at_a[axis] = total(a[axis]) - back_a * edge.direction[axis];
    result.at_b[axis] = total(b[axis]) - back_b * edge.direction[axis];
  }
  return result;
}

double
invert(double* densities, std::size_t count)
{
  const D d;
  const V one = constant(1), least = constant(1e-300);
  for (std::size_t k = count; k < count + hn::Lanes(d); ++k)
    densities[k] = 1;
  V sum = hn::Zero(d);
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    const V density = hn::Max(hn::LoadU(d, densities + k), least);
    sum = hn::Add(sum, hn::Log(d, density));
    hn::StoreU(hn::Div(one, density), d, densities + k);
  }
  return hn::GetLane(hn::SumOfLanes(d, sum));
}

double
share(const double* inverse,
      const Index* sorted_index,
      double* densities,
      std::size_t count)
{
  const D d;
  const hn::RebindToUnsigned<D> u;
  const hn::RebindToSigned<D> i;
  const hn::Rebind<Index, D> h;
  V sum = hn::Zero(d);
  std::size_t k = 0;
  for (; k + hn::Lanes(d) <= count; k += hn::Lanes(d)) {
    const auto at = hn::BitCast(i, hn::PromoteTo(u, hn::LoadU(h, sorted_index + k)));
    const V part =
        hn::Mul(hn::LoadU(d, densities + k), hn::GatherIndex(d, inverse, at));
    hn::StoreU(part, d, densities + k);
    sum = hn::Add(sum, part);
  }
  double total = hn::GetLane(hn::SumOfLanes(d, sum));
  for (; k < count; ++k) { // past these lie the densities of the next edge
    densities[k] *= inverse[sorted_index[k]];
    total += densities[k];
  }
  return total;
}

EmKernels
emLoops()
{
  return {densities, sums, invert, share};
}

} // namespace HWY_NAMESPACE
} // namespace linelet
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace linelet {

HWY_EXPORT(emLoops);

const EmKernels&
emKernels()
{
  static const EmKernels chosen = HWY_DYNAMIC_DISPATCH(emLoops)();
  return chosen;
}

} // namespace linelet

#endif
