// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "sorted_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "curves/ridges/sorted_kernels.cpp"
#include <hwy/foreach_target.h> // includes this file once per instruction set

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linelet {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, SortedArrays::padding>;
using U = hn::RebindToUnsigned<D>;
using H = hn::Rebind<Index, D>;
using I = hn::RebindToSigned<D>;
using V = hn::Vec<D>;

HWY_INLINE V
constant(double value)
{
  return hn::Set(D(), value);
}

void
fieldSums(const SortedArrays& points,
          const std::vector<SortedRun>& runs,
          const double* query,
          double radius,
          FieldSums& sums)
{
  const D d;
  const V zero = hn::Zero(d), one = constant(1);
  const V inverse = constant(1 / (radius * radius));
  const V qx = constant(query[0]), qy = constant(query[1]), qz = constant(query[2]);
  const V lanes = hn::Iota(d, 0);
  V weight = zero, wx = zero, wy = zero, wz = zero;
  V xx = zero, xy = zero, xz = zero, yy = zero, yz = zero, zz = zero;
  for (const SortedRun& run : runs)
    for (std::size_t k = run.begin; k < run.end; k += hn::Lanes(d)) {
      const V x = hn::Sub(hn::LoadU(d, points.axis[0].data() + k), qx);
      const V y = hn::Sub(hn::LoadU(d, points.axis[1].data() + k), qy);
      const V z = hn::Sub(hn::LoadU(d, points.axis[2].data() + k), qz);
      const V squared = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
      const V u = hn::Max(zero, hn::NegMulAdd(squared, inverse, one));
      const V u2 = hn::Mul(u, u);
      const V rest = constant(static_cast<double>(run.end - k));
      const V w = hn::IfThenElseZero(hn::Lt(lanes, rest), hn::Mul(u2, u2));
      const V vx = hn::Mul(w, x), vy = hn::Mul(w, y), vz = hn::Mul(w, z);
      weight = hn::Add(weight, w);
      wx = hn::Add(wx, vx);
      wy = hn::Add(wy, vy);
      wz = hn::Add(wz, vz);
      xx = hn::MulAdd(vx, x, xx);
      xy = hn::MulAdd(vx, y, xy);
      xz = hn::MulAdd(vx, z, xz);
      yy = hn::MulAdd(vy, y, yy);
      yz = hn::MulAdd(vy, z, yz);
      zz = hn::MulAdd(vz, z, zz);
    }
  const auto total = [&](V v) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(d, v)); };
  sums = {total(weight),
          {total(wx), total(wy), total(wz)},
          {total(xx), total(xy), total(xz), total(yy), total(yz), total(zz)}};
}

std::size_t
nearEdge(const SortedArrays& points,
         const std::vector<SortedRun>& runs,
         const NearEdge& edge,
         Index* sorted_indices,
         const std::array<double*, 3>& at)
{
  const D d;
  const V zero = hn::Zero(d), lanes = hn::Iota(d, 0);
  const V fx = constant(edge.from[0]), fy = constant(edge.from[1]),
          fz = constant(edge.from[2]);
  const V dx = constant(edge.direction[0]), dy = constant(edge.direction[1]),
          dz = constant(edge.direction[2]);
  const V length = constant(edge.length), most = constant(edge.reach * edge.reach);
  std::size_t count = 0;
  for (const SortedRun& run : runs)
    for (std::size_t k = run.begin; k < run.end; k += hn::Lanes(d)) {
      const V px = hn::LoadU(d, points.axis[0].data() + k);
      const V py = hn::LoadU(d, points.axis[1].data() + k);
      const V pz = hn::LoadU(d, points.axis[2].data() + k);
      const V x = hn::Sub(px, fx), y = hn::Sub(py, fy), z = hn::Sub(pz, fz);
      const V along = hn::MulAdd(x, dx, hn::MulAdd(y, dy, hn::Mul(z, dz)));
      const V over = hn::Sub(along, hn::Min(hn::Max(along, zero), length));
      const V squared = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
      const V off = hn::MulAdd(over, over, hn::NegMulAdd(along, along, squared));
      const V rest = constant(static_cast<double>(run.end - k));
      const auto near = hn::And(hn::Le(off, most), hn::Lt(lanes, rest));
      if (hn::AllFalse(d, near))
        continue;
      // Faster than compressing vectors: every sorted index is written, and overwritten
      // if it was not near.
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(d, near, bits);
      const unsigned mask = bits[0] | unsigned(bits[1]) << 8;
      for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        sorted_indices[count] = static_cast<Index>(k + lane);
        count += mask >> lane & 1u;
      }
    }
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    for (std::size_t lane = count; lane < k + hn::Lanes(d); ++lane)
      sorted_indices[lane] = 0;
    const auto sorted_index =
        hn::BitCast(I(), hn::PromoteTo(U(), hn::LoadU(H(), sorted_indices + k)));
    for (std::size_t axis = 0; axis < 3; ++axis)
      hn::StoreU(
          hn::GatherIndex(d, points.axis[axis].data(), sorted_index), d, at[axis] + k);
  }
  return count;
}

SortedKernels
sortedLoops()
{
  return {fieldSums, nearEdge};
}

} // namespace HWY_NAMESPACE
} // namespace linelet
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace linelet {

HWY_EXPORT(sortedLoops);

const SortedKernels&
sortedKernels()
{
  static const SortedKernels chosen = HWY_DYNAMIC_DISPATCH(sortedLoops)();
  return chosen;
}

} // namespace linelet

#endif
