// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sorting candidates by the scales that can reach them. Included once per instruction
// set, so it has a guard that toggles.

#if defined(LINELET_GRID_MULTI_SCALE_LISTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_MULTI_SCALE_LISTS_INL
#undef LINELET_GRID_MULTI_SCALE_LISTS_INL
#else
#define LINELET_GRID_MULTI_SCALE_LISTS_INL
#endif

#include <cstring>

#include <hwy/highway.h>

#include "multi_scale_kernels.h"
#include "support/append-inl.h"
#include "weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

using linelet::HWY_NAMESPACE::append;

template <class Mask>
HWY_INLINE std::uint32_t
bitsOf(Mask mask)
{
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(F(), mask, bytes);
  return bytes[0] | std::uint32_t{bytes[1]} << 8;
}

/** \brief Entries of a list that are not padding. */
HWY_INLINE auto
present(const PointList& list, std::size_t i)
{
  return hn::FirstN(F(), HWY_MIN(list.size - i, hn::Lanes(F())));
}

std::size_t
splitGroups(const PointList& groups,
            const Float3& center,
            float near,
            float far,
            PointList& open,
            std::uint32_t* certain)
{
  const F f;
  const hn::RebindToUnsigned<F> u;
  const V cx = constant(center[0]), cy = constant(center[1]), cz = constant(center[2]);
  std::size_t size = 0, count = 0;
  for (std::size_t i = 0; i < groups.size; i += hn::Lanes(f)) {
    const V x = hn::Load(f, groups.x + i), y = hn::Load(f, groups.y + i),
            z = hn::Load(f, groups.z + i), radius = hn::Load(f, groups.h + i);
    const V dx = hn::Sub(x, cx), dy = hn::Sub(y, cy), dz = hn::Sub(z, cz);
    const V squared = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
    const V most = hn::Add(constant(far), radius),
            least = hn::Sub(constant(near), radius);
    const auto reached =
        hn::And(present(groups, i), hn::Le(squared, hn::Mul(most, most)));
    if (hn::AllFalse(f, reached))
      continue;
    const auto within =
        hn::And(hn::Gt(least, hn::Zero(f)), hn::Lt(squared, hn::Mul(least, least)));
    const auto whole = hn::And(reached, within), keep = hn::AndNot(within, reached);
    const auto id = hn::Load(u, groups.id + i);
    append(u, id, hn::RebindMask(u, whole), certain + count);
    count += hn::CountTrue(f, whole);
    append(f, x, keep, open.x + size);
    append(f, y, keep, open.y + size);
    append(f, z, keep, open.z + size);
    append(f, radius, keep, open.h + size);
    append(u, id, hn::RebindMask(u, keep), open.id + size);
    size += hn::CountTrue(f, keep);
  }
  open.size = size;
  return count;
}

/** \brief Moments of points, lane by lane, in float. */
struct PointSums {
  V x, y, z, xx, xy, xz, yy, yz, zz;
  std::size_t count = 0;

  HWY_INLINE
  PointSums() { x = y = z = xx = xy = xz = yy = yz = zz = hn::Zero(F()); }

  template <class Mask>
  HWY_INLINE void
  add(Mask mask, V px, V py, V pz)
  {
    const V vx = hn::IfThenElseZero(mask, px), vy = hn::IfThenElseZero(mask, py),
            vz = hn::IfThenElseZero(mask, pz);
    x = hn::Add(x, vx);
    y = hn::Add(y, vy);
    z = hn::Add(z, vz);
    xx = hn::MulAdd(vx, vx, xx);
    xy = hn::MulAdd(vx, vy, xy);
    xz = hn::MulAdd(vx, vz, xz);
    yy = hn::MulAdd(vy, vy, yy);
    yz = hn::MulAdd(vy, vz, yz);
    zz = hn::MulAdd(vz, vz, zz);
    count += hn::CountTrue(F(), mask);
  }

  HWY_INLINE void
  addTo(Moments& sums) const
  {
    const auto sum = [](V v) HWY_ATTR {
      return static_cast<double>(hn::GetLane(hn::SumOfLanes(F(), v)));
    };
    sums.count += static_cast<double>(count);
    sums.first += Point(sum(x), sum(y), sum(z));
    sums.xx += sum(xx);
    sums.xy += sum(xy);
    sums.xz += sum(xz);
    sums.yy += sum(yy);
    sums.yz += sum(yz);
    sums.zz += sum(zz);
  }
};

/** \brief Coordinates of some points. */
struct PointVector {
  V x, y, z;
};

/** \brief Points from \a sorted_index on, made from double. */
HWY_INLINE PointVector
sharpPoints(const BlockOrder& order, std::size_t sorted_index, const GroupView& view)
{
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, hn::ScalableTag<double>> half;
  const auto scale = hn::Set(d, view.scale);
  const auto along = [&](int axis) HWY_ATTR {
    const double* const values = order.coordinate(axis) + sorted_index;
    const auto origin = hn::Set(d, view.origin[axis]);
    const auto part = [&](const double* at) HWY_ATTR {
      return hn::DemoteTo(half, hn::Mul(hn::Sub(hn::LoadU(d, at), origin), scale));
    };
#if HWY_TARGET == HWY_SCALAR
    return part(values);
#else
    return hn::Combine(F(), part(values + hn::Lanes(d)), part(values));
#endif
  };
  return {along(0), along(1), along(2)};
}

void
placeGroup(GroupPlaces& places, std::size_t group, const GroupView& view)
{
  const F f;
  const V far = constant(PointList::far_away);
  const std::size_t size = places.size[group];
  for (std::size_t i = 0; i < PointGroups::most_points; i += hn::Lanes(f)) {
    const PointVector p = sharpPoints(places.order, places.begin[group] + i, view);
    const auto here = hn::FirstN(f, size - HWY_MIN(i, size));
    const std::size_t at = group * PointGroups::most_points + i;
    hn::Store(hn::IfThenElse(here, p.x, far), f, places.points.x + at);
    hn::Store(hn::IfThenElse(here, p.y, far), f, places.points.y + at);
    hn::Store(hn::IfThenElse(here, p.z, far), f, places.points.z + at);
  }
}

void
openGroups(const PointList& groups,
           const GroupPlaces& places,
           const GroupView& view,
           float near,
           float far,
           PointList& open,
           Moments& certain)
{
  const F f;
  const hn::RebindToUnsigned<F> u;
  const auto lane = hn::Iota(u, 0);
  const V cx = constant(view.center[0]), cy = constant(view.center[1]),
          cz = constant(view.center[2]);
  constexpr std::size_t most_groups = 64; // then the sum continues in double
  std::size_t size = 0;
  for (std::size_t first = 0; first < groups.size; first += most_groups) {
    PointSums sums;
    for (std::size_t g = first; g < HWY_MIN(first + most_groups, groups.size); ++g) {
      const std::uint32_t id = groups.id[g], begin = places.begin[id];
      for (std::size_t i = 0; i < places.size[id]; i += hn::Lanes(f)) {
        const std::size_t at = id * PointGroups::most_points + i;
        PointVector p = {hn::Sub(hn::Load(f, places.points.x + at), cx),
                         hn::Sub(hn::Load(f, places.points.y + at), cy),
                         hn::Sub(hn::Load(f, places.points.z + at), cz)};
        V h = hn::MulAdd(p.x, p.x, hn::MulAdd(p.y, p.y, hn::Mul(p.z, p.z)));
        auto reached = hn::Le(h, constant(far)); // padding is beyond
        if (!hn::AllFalse(f, hn::Le(h, constant(view.sharp)))) {
          p = sharpPoints(places.order, begin + i, view);
          h = hn::MulAdd(p.x, p.x, hn::MulAdd(p.y, p.y, hn::Mul(p.z, p.z)));
        }
        const auto within = hn::And(reached, hn::Lt(h, constant(near)));
        const auto keep = hn::AndNot(within, reached);
        if (!hn::AllFalse(f, within))
          sums.add(within, p.x, p.y, p.z);
        append(f, p.x, keep, open.x + size);
        append(f, p.y, keep, open.y + size);
        append(f, p.z, keep, open.z + size);
        append(f, h, keep, open.h + size);
        const auto sorted_index =
            hn::Add(lane, hn::Set(u, begin + static_cast<std::uint32_t>(i)));
        append(u, sorted_index, hn::RebindMask(u, keep), open.id + size);
        size += hn::CountTrue(f, keep);
      }
    }
    if (sums.count > 0)
      sums.addTo(certain);
  }
  open.size = size;
  open.pad();
}

void
order(PointList& list,
      PointList& spare,
      const LeafScale* scales,
      std::size_t count,
      std::size_t* ends)
{
  const F f;
  const hn::RebindToUnsigned<F> u;
  spare.reserve(list.size);
  std::size_t end = list.size;
  ends[count - 1] = end;
  for (std::size_t k = count - 1; k-- > 0;) {
    const V limit = constant(scales[k].far);
    std::size_t near = 0, far = 0;
    // The last vector is written whole; the points of larger scales come after it.
    const V x_behind = hn::LoadU(f, list.x + end),
            y_behind = hn::LoadU(f, list.y + end),
            z_behind = hn::LoadU(f, list.z + end),
            h_behind = hn::LoadU(f, list.h + end);
    const auto id_behind = hn::LoadU(u, list.id + end);
    for (std::size_t i = 0; i < end; i += hn::Lanes(f)) {
      const V x = hn::Load(f, list.x + i), y = hn::Load(f, list.y + i),
              z = hn::Load(f, list.z + i), h = hn::Load(f, list.h + i);
      const auto id = hn::Load(u, list.id + i);
      const auto inside = hn::FirstN(f, HWY_MIN(end - i, hn::Lanes(f)));
      const auto keep = hn::And(inside, hn::Le(h, limit));
      const auto leave = hn::AndNot(keep, inside);
      const auto store = [&](PointList& to, std::size_t at, auto mask) HWY_ATTR {
        append(f, x, mask, to.x + at);
        append(f, y, mask, to.y + at);
        append(f, z, mask, to.z + at);
        append(f, h, mask, to.h + at);
        append(u, id, hn::RebindMask(u, mask), to.id + at);
      };
      // Never further than what has been read.
      store(list, near, keep);
      store(spare, far, leave);
      near += hn::CountTrue(f, keep);
      far += hn::CountTrue(f, leave);
    }
    hn::StoreU(x_behind, f, list.x + end);
    hn::StoreU(y_behind, f, list.y + end);
    hn::StoreU(z_behind, f, list.z + end);
    hn::StoreU(h_behind, f, list.h + end);
    hn::StoreU(id_behind, u, list.id + end);
    std::memcpy(list.x + near, spare.x, far * sizeof(float));
    std::memcpy(list.y + near, spare.y, far * sizeof(float));
    std::memcpy(list.z + near, spare.z, far * sizeof(float));
    std::memcpy(list.h + near, spare.h, far * sizeof(float));
    std::memcpy(list.id + near, spare.id, far * sizeof(std::uint32_t));
    ends[k] = end = near;
  }
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
