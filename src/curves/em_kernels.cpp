// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "em_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "curves/em_kernels.cpp"
#include <hwy/foreach_target.h> // includes this file once per instruction set

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

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

/** \brief exp(-z (1.5976 + 0.07056 z^2)), held to where its square is finite: the
 * normal distribution function at z is 1 / (1 + this), to 2e-4. */
HWY_INLINE V
normalOdds(V z)
{
  const V slope = hn::MulAdd(hn::Mul(z, z), constant(-0.07056), constant(-1.5976));
  const V exponent = hn::Min(hn::Max(hn::Mul(z, slope), constant(-300)), constant(300));
  return hn::Exp(D(), exponent);
}

void
densities(const EdgeShape& edge,
          const EdgePoints& points,
          double* density,
          double* place,
          double* off)
{
  const D d;
  const V dx = constant(edge.direction[0]), dy = constant(edge.direction[1]),
          dz = constant(edge.direction[2]);
  const V fx = constant(edge.from[0]), fy = constant(edge.from[1]),
          fz = constant(edge.from[2]);
  const V factor = constant(edge.factor), least = constant(-700);
  const V half_variance = constant(-0.5 / edge.variance);
  const V half_along =
      constant(-0.5 / (edge.variance + edge.length * edge.length / 12));
  const V length = constant(edge.length), middle = constant(0.5 * edge.length);
  const V inverse_noise = hn::Div(constant(1), hn::Sqrt(constant(edge.variance)));
  for (std::size_t k = 0; k < points.count; k += hn::Lanes(d)) {
    const V x = hn::Sub(hn::LoadU(d, points.x + k), fx);
    const V y = hn::Sub(hn::LoadU(d, points.y + k), fy);
    const V z = hn::Sub(hn::LoadU(d, points.z + k), fz);
    const V at = hn::MulAdd(x, dx, hn::MulAdd(y, dy, hn::Mul(z, dz)));
    const V squared = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
    const V away = hn::Max(hn::Zero(d), hn::NegMulAdd(at, at, squared));
    V exponent = hn::Mul(away, half_variance);
    V value;
    if (edge.is_short) {
      const V t = hn::Sub(at, middle);
      exponent = hn::MulAdd(hn::Mul(t, t), half_along, exponent);
      value = hn::Mul(factor, hn::Exp(d, hn::Max(exponent, least)));
    }
    else {
      const V before = normalOdds(hn::Mul(hn::Sub(length, at), inverse_noise));
      const V after = normalOdds(hn::Neg(hn::Mul(at, inverse_noise)));
      const V one = constant(1);
      const V within = hn::Div(hn::Sub(after, before),
                               hn::Mul(hn::Add(one, before), hn::Add(one, after)));
      value = hn::Mul(hn::Mul(factor, within), hn::Exp(d, hn::Max(exponent, least)));
    }
    hn::StoreU(value, d, density + k);
    hn::StoreU(at, d, place + k);
    hn::StoreU(away, d, off + k);
  }
}

EdgeSums
sums(const EdgeShape& edge,
     const EdgePoints& points,
     const double* share,
     const double* place,
     bool front,
     bool back)
{
  const D d;
  const V zero = hn::Zero(d);
  // Where on the edge the point came from: uniform on the edge, normal around z.
  const double middle_weight = 12 / (edge.length * edge.length);
  const double spread = 1 / (1 / edge.variance + middle_weight);
  const V slope = constant(spread / edge.variance);
  const V offset = constant(0.5 * spread * edge.length * middle_weight);
  const V length = constant(edge.length), inverse_length = constant(1 / edge.length);
  V aa = zero, ab = zero, bb = zero, shift_a = zero, shift_b = zero;
  V a[3] = {zero, zero, zero}, b[3] = {zero, zero, zero};
  const V lanes = hn::Iota(d, 0);
  for (std::size_t k = 0; k < points.count; k += hn::Lanes(d)) {
    V r = hn::LoadU(d, share + k);
    const V rest = constant(static_cast<double>(points.count - k));
    r = hn::IfThenElseZero(
        hn::And(hn::Ge(r, constant(least_share)), hn::Lt(lanes, rest)), r);
    const V z = hn::LoadU(d, place + k);
    const V on = hn::Min(hn::Max(hn::MulAdd(slope, z, offset), zero), length);
    // Along the curve only its ends are drawn by the points.
    V shift = hn::Sub(z, on);
    if (front)
      shift = hn::IfThenElse(hn::Lt(z, zero), zero, shift);
    if (back)
      shift = hn::IfThenElse(hn::Gt(z, length), zero, shift);
    const V t = hn::Mul(on, inverse_length);
    const V to_b = hn::Mul(r, t), to_a = hn::Sub(r, to_b);
    bb = hn::MulAdd(to_b, t, bb);
    ab = hn::MulAdd(to_a, t, ab);
    aa = hn::Add(aa, hn::NegMulAdd(to_a, t, to_a));
    shift_a = hn::MulAdd(to_a, shift, shift_a);
    shift_b = hn::MulAdd(to_b, shift, shift_b);
    const double* coordinates[3] = {points.x, points.y, points.z};
    for (int axis = 0; axis < 3; ++axis) {
      const V x = hn::LoadU(d, coordinates[axis] + k);
      a[axis] = hn::MulAdd(to_a, x, a[axis]);
      b[axis] = hn::MulAdd(to_b, x, b[axis]);
    }
  }
  const auto total = [&](V v) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(d, v)); };
  EdgeSums result;
  result.aa = total(aa);
  result.ab = total(ab);
  result.bb = total(bb);
  const double moved_a = total(shift_a), moved_b = total(shift_b);
  for (int axis = 0; axis < 3; ++axis) {
    result.at_a[axis] = total(a[axis]) - moved_a * edge.direction[axis];
    result.at_b[axis] = total(b[axis]) - moved_b * edge.direction[axis];
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

EmKernels
emLoops()
{
  return {densities, sums, invert};
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
