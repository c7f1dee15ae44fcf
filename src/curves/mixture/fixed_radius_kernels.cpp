// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fixed_radius_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "curves/mixture/fixed_radius_kernels.cpp"
#include <hwy/foreach_target.h> // includes this file once per instruction set

#include <hwy/highway.h>

#include "quick_exp-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, EdgePoints::padding>;
using U = hn::RebindToUnsigned<D>;
using H = hn::Rebind<Index, D>;
using I = hn::RebindToSigned<D>;
using V = hn::Vec<D>;

// Shares below this one are left out.
constexpr double least_share = 1e-5;
// In widths of the sphere: the density is zero beyond reach, and practically linear
// within narrow.
constexpr double reach = 4;
constexpr double narrow = 0.3;

HWY_INLINE V
constant(double value)
{
  return hn::Set(D(), value);
}

/** \brief A place on an edge, seen from a point. */
struct Mark {
  V place;
  V residual; // of its distance from the radius, in widths
  V density;  // of the standard normal distribution there
  V above;    // probability of a larger residual
};

/** \brief Sums over the places of an edge, by density; residuals in widths. */
struct Sums {
  V density, place, residual, spread;
};

HWY_INLINE Mark
markAt(V place, V distance, V radius, V inverse_width)
{
  const D d;
  const V one = constant(1);
  const V u = hn::Mul(hn::Sub(distance, radius), inverse_width);
  const V power =
      quickExp(d, hn::Max(hn::Mul(constant(-0.5), hn::Mul(u, u)), constant(-700)));
  // Abramowitz and Stegun 7.1.26, to 1e-7.
  const V t = hn::Div(one, hn::MulAdd(constant(0.23164190), hn::Abs(u), one));
  V tail = constant(0.5 * 1.061405429);
  for (const double c : {-1.453152027, 1.421413741, -0.284496736, 0.254829592})
    tail = hn::MulAdd(tail, t, constant(0.5 * c));
  tail = hn::Mul(hn::Mul(tail, t), power);
  const V above = hn::IfThenElse(hn::Lt(u, hn::Zero(d)), hn::Sub(one, tail), tail);
  return {place, u, hn::Mul(constant(0.3989422804014327), power), above};
}

/** \brief Adds the places from \a foot, the nearest, to \a end; the distance is taken
 * as linear in between. */
HWY_INLINE void
addPart(const Mark& foot, const Mark& end, Sums& sums)
{
  const V a = foot.residual, b = end.residual;
  const V height = hn::Sub(b, a), middle = hn::Mul(constant(0.5), hn::Add(a, b));
  const auto is_narrow = hn::Lt(height, constant(narrow));
  const V inverse_height = hn::Div(constant(1), hn::Max(height, constant(narrow)));
  // Moments of the normal distribution between a and b.
  const V inside = hn::Max(hn::Sub(foot.above, end.above), constant(1e-12));
  const V inverse_inside = hn::Div(constant(1), inside);
  const V slope = hn::Sub(hn::Mul(b, end.density), hn::Mul(a, foot.density));
  V mean = hn::Mul(hn::Sub(foot.density, end.density), inverse_inside);
  mean = hn::IfThenElse(is_narrow, middle, hn::Min(hn::Max(mean, a), b));
  V square = hn::Mul(mean, mean);
  const V whole = hn::NegMulAdd(slope, inverse_inside, constant(1));
  square = hn::IfThenElse(is_narrow, square, hn::Max(square, whole));
  const V flat = hn::MulAdd(hn::Mul(height, constant(1.0 / 12)),
                            slope,
                            hn::Mul(constant(0.5), hn::Add(foot.density, end.density)));
  V density = hn::IfThenElse(is_narrow, flat, hn::Mul(inside, inverse_height));
  density = hn::IfThenElseZero(
      hn::And(hn::Le(a, constant(reach)), hn::Ge(b, constant(-reach))), density);

  const V along = hn::Sub(end.place, foot.place);
  const V at = hn::IfThenElse(
      is_narrow, constant(0.5), hn::Mul(hn::Sub(mean, a), inverse_height));
  const V mass = hn::Mul(hn::Abs(along), density);
  sums.density = hn::Add(sums.density, mass);
  sums.place = hn::MulAdd(mass, hn::MulAdd(along, at, foot.place), sums.place);
  sums.residual = hn::MulAdd(mass, mean, sums.residual);
  sums.spread = hn::MulAdd(mass, square, sums.spread);
}

void
densities(const EdgeShape& edge,
          const FixedRadius& noise,
          const EdgePoints& points,
          double* density,
          const FixedRadiusMeans& means)
{
  const D d;
  const V zero = hn::Zero(d), length = constant(edge.length);
  const V radius = constant(noise.radius), width = constant(noise.width);
  const V inverse_width = constant(1 / noise.width);
  const V factor = constant(edge.factor / noise.width);
  for (std::size_t k = 0; k < points.count; k += hn::Lanes(d)) {
    const V x = hn::Sub(hn::LoadU(d, points.x + k), constant(edge.from[0]));
    const V y = hn::Sub(hn::LoadU(d, points.y + k), constant(edge.from[1]));
    const V z = hn::Sub(hn::LoadU(d, points.z + k), constant(edge.from[2]));
    const V along = hn::MulAdd(x,
                               constant(edge.direction[0]),
                               hn::MulAdd(y,
                                          constant(edge.direction[1]),
                                          hn::Mul(z, constant(edge.direction[2]))));
    const V squared = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
    const V off = hn::Max(zero, hn::NegMulAdd(along, along, squared));
    const auto mark = [&](V place) HWY_ATTR {
      const V gap = hn::Sub(along, place);
      const V distance = hn::Sqrt(hn::MulAdd(gap, gap, off));
      return markAt(place, distance, radius, inverse_width);
    };
    // The distance from the point falls toward its foot and grows after it.
    const Mark foot = mark(hn::Min(hn::Max(along, zero), length));
    Sums sums = {zero, zero, zero, zero};
    addPart(foot, mark(zero), sums);
    addPart(foot, mark(length), sums);
    const V share = hn::IfThenElseZero(hn::Gt(sums.density, zero),
                                       hn::Div(constant(1), sums.density));
    const V scale = hn::Mul(share, width);
    hn::StoreU(hn::Mul(factor, sums.density), d, density + k);
    hn::StoreU(hn::Mul(share, sums.place), d, means.place + k);
    hn::StoreU(hn::Mul(scale, sums.residual), d, means.residual + k);
    hn::StoreU(hn::Mul(hn::Mul(scale, width), sums.spread), d, means.spread + k);
  }
}

EdgeSums
sums(const EdgeShape& edge,
     const FixedRadius& noise,
     const EdgePoints& points,
     const double* share,
     const FixedRadiusMeans& means,
     const Index* sorted_index,
     const double* information,
     bool front,
     bool back)
{
  const D d;
  const V zero = hn::Zero(d), tiny = constant(1e-300), lanes = hn::Iota(d, 0);
  const V length = constant(edge.length), inverse_length = constant(1 / edge.length);
  const V width = constant(noise.width);
  const double* const coordinates[3] = {points.x, points.y, points.z};
  V aa = zero, ab = zero, bb = zero;
  V a[3] = {zero, zero, zero}, b[3] = {zero, zero, zero};
  for (std::size_t k = 0; k < points.count; k += hn::Lanes(d)) {
    const auto at =
        hn::BitCast(I(), hn::PromoteTo(U(), hn::LoadU(H(), sorted_index + k)));
    const V says = hn::GatherIndex(d, information, at);
    const V rest = constant(static_cast<double>(points.count - k));
    V r = hn::Mul(hn::LoadU(d, share + k), says);
    r = hn::IfThenElseZero(
        hn::And(hn::Ge(r, constant(least_share)), hn::Lt(lanes, rest)), r);
    const V place = hn::LoadU(d, means.place + k);
    V offset[3], along = zero, squared = zero;
    for (int axis = 0; axis < 3; ++axis) {
      const V direction = constant(edge.direction[axis]);
      const V source = hn::MulAdd(place, direction, constant(edge.from[axis]));
      offset[axis] = hn::Sub(hn::LoadU(d, coordinates[axis] + k), source);
      along = hn::MulAdd(offset[axis], direction, along);
      squared = hn::MulAdd(offset[axis], offset[axis], squared);
    }
    const V residual = hn::Div(hn::LoadU(d, means.residual + k), hn::Max(says, tiny));
    const V move = hn::Div(hn::Min(hn::Max(residual, hn::Neg(width)), width),
                           hn::Max(hn::Sqrt(squared), tiny));
    // Along the curve, points pull only on its ends.
    if (front)
      along = hn::IfThenZeroElse(hn::Le(place, zero), along);
    if (back)
      along = hn::IfThenZeroElse(hn::Ge(place, length), along);
    const V t = hn::Mul(place, inverse_length);
    const V to_b = hn::Mul(r, t), to_a = hn::Sub(r, to_b);
    bb = hn::MulAdd(to_b, t, bb);
    ab = hn::MulAdd(to_a, t, ab);
    aa = hn::Add(aa, hn::NegMulAdd(to_a, t, to_a));
    for (int axis = 0; axis < 3; ++axis) {
      const V direction = constant(edge.direction[axis]);
      const V source = hn::MulAdd(place, direction, constant(edge.from[axis]));
      const V drawn = hn::NegMulAdd(along, direction, offset[axis]);
      const V to = hn::MulAdd(move, drawn, source);
      a[axis] = hn::MulAdd(to_a, to, a[axis]);
      b[axis] = hn::MulAdd(to_b, to, b[axis]);
    }
  }
  const auto total = [&](V v) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(d, v)); };
  EdgeSums result;
  result.aa = total(aa);
  result.ab = total(ab);
  result.bb = total(bb);
  for (int axis = 0; axis < 3; ++axis) {
    result.at_a[axis] = total(a[axis]);
    result.at_b[axis] = total(b[axis]);
  }
  return result;
}

FixedRadiusKernels
fixedRadiusLoops()
{
  return {densities, sums};
}

} // namespace HWY_NAMESPACE
} // namespace linelet
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace linelet {

HWY_EXPORT(fixedRadiusLoops);

const FixedRadiusKernels&
fixedRadiusKernels()
{
  static const FixedRadiusKernels chosen = HWY_DYNAMIC_DISPATCH(fixedRadiusLoops)();
  return chosen;
}

} // namespace linelet

#endif
