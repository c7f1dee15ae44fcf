// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sorting candidates by the scales that can reach them. Included once per instruction
// set, so it has a guard that toggles.

#if defined(LINELET_GRID_LADDER_LISTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_LADDER_LISTS_INL
#undef LINELET_GRID_LADDER_LISTS_INL
#else
#define LINELET_GRID_LADDER_LISTS_INL
#endif

#include <cstring>

#include <hwy/highway.h>

#include "ladder_kernels.h"
#include "weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

/** \brief Stores the lanes of \a mask one after the other; a whole vector is written.
 */
template <class Tag, class Vector, class Mask>
HWY_INLINE void
put(Tag tag, Vector vector, Mask mask, hn::TFromD<Tag>* at)
{
  hn::StoreU(hn::Compress(vector, mask), tag, at);
}

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

/** \brief Appends entries of \a in to \a out, which grows. */
template <class Mask>
HWY_INLINE void
appendPoints(PointList& out, Mask mask, V x, V y, V z)
{
  const F f;
  out.extend(hn::Lanes(f));
  put(f, x, mask, out.x + out.size);
  put(f, y, mask, out.y + out.size);
  put(f, z, mask, out.z + out.size);
}

void
splitNode(const PointList& in,
          const Float3& center,
          float core,
          const LadderScale* scales,
          std::size_t count,
          PointList* shells,
          PointList& out)
{
  const F f;
  const hn::RebindToUnsigned<F> u;
  const V cx = constant(center[0]), cy = constant(center[1]), cz = constant(center[2]);
  const V inner = constant(core), most = constant(scales[count - 1].far);
  out.size = 0;
  for (std::size_t i = 0; i < in.size; i += hn::Lanes(f)) {
    const V x = hn::Load(f, in.x + i), y = hn::Load(f, in.y + i),
            z = hn::Load(f, in.z + i);
    const V dx = hn::Sub(x, cx), dy = hn::Sub(y, cy), dz = hn::Sub(z, cz);
    const V h = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
    auto rest = hn::Le(h, most); // padding is beyond
    if (hn::AllFalse(f, rest))
      continue;
    // Points that follow each other lie together: few scales tell them apart.
    const float least = hn::GetLane(hn::MinOfLanes(f, h));
    std::size_t k = 0;
    while (least > scales[k].far)
      ++k;
    auto open = hn::Le(h, inner);
    for (; !hn::AllFalse(f, rest); ++k) {
      const auto reached = hn::And(rest, hn::Le(h, constant(scales[k].far)));
      const auto within = hn::Lt(h, constant(scales[k].near));
      const auto certain = hn::AndNot(open, hn::And(reached, within));
      if (!hn::AllFalse(f, certain)) {
        appendPoints(shells[k], certain, dx, dy, dz);
        shells[k].size += hn::CountTrue(f, certain);
      }
      open = hn::Or(open, hn::AndNot(within, reached));
      rest = hn::AndNot(reached, rest);
    }
    open = hn::And(open, hn::Le(h, most));
    put(f, x, open, out.x + out.size);
    put(f, y, open, out.y + out.size);
    put(f, z, open, out.z + out.size);
    put(u, hn::Load(u, in.id + i), hn::RebindMask(u, open), out.id + out.size);
    out.size += hn::CountTrue(f, open);
  }
  for (std::size_t k = 0; k < count; ++k)
    shells[k].pad();
  out.pad();
}

void
splitLeaf(const PointList& in,
          const LadderScale* scales,
          std::size_t count,
          PointList* certain,
          PointList* open)
{
  const F f;
  const hn::RebindToUnsigned<F> u;
  const V most = constant(scales[count - 1].far);
  for (std::size_t i = 0; i < in.size; i += hn::Lanes(f)) {
    const V h = hn::Load(f, in.h + i);
    auto rest = hn::Le(h, most); // padding is beyond
    if (hn::AllFalse(f, rest))
      continue;
    const V x = hn::Load(f, in.x + i), y = hn::Load(f, in.y + i),
            z = hn::Load(f, in.z + i);
    const float least = hn::GetLane(hn::MinOfLanes(f, h));
    std::size_t k = 0;
    while (least > scales[k].far)
      ++k;
    for (; k < count && !hn::AllFalse(f, rest); ++k) {
      const auto within = hn::And(rest, hn::Lt(h, constant(scales[k].near)));
      rest = hn::AndNot(within, rest);
      const auto reached = hn::And(rest, hn::Le(h, constant(scales[k].far)));
      if (!hn::AllFalse(f, within)) {
        appendPoints(certain[k], within, x, y, z);
        certain[k].size += hn::CountTrue(f, within);
      }
      if (!hn::AllFalse(f, reached)) {
        PointList& list = open[k];
        appendPoints(list, reached, x, y, z);
        put(f, h, reached, list.h + list.size);
        put(u, hn::Load(u, in.id + i), hn::RebindMask(u, reached), list.id + list.size);
        list.size += hn::CountTrue(f, reached);
      }
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    certain[k].pad();
    open[k].pad();
  }
}

void
addMoments(const PointList& list, Moments& sums)
{
  const F f;
  const std::size_t lanes = hn::Lanes(f);
  constexpr std::size_t chunk_vectors = 64; // then the sum goes on in double
  for (std::size_t chunk = 0; chunk < list.size; chunk += chunk_vectors * lanes) {
    const std::size_t end = HWY_MIN(chunk + chunk_vectors * lanes, list.size);
    V sx = hn::Zero(f), sy = sx, sz = sx, xx = sx, xy = sx, xz = sx, yy = sx, yz = sx,
      zz = sx;
    for (std::size_t i = chunk; i < end; i += lanes) {
      const auto here = present(list, i);
      const V x = hn::IfThenElseZero(here, hn::Load(f, list.x + i)),
              y = hn::IfThenElseZero(here, hn::Load(f, list.y + i)),
              z = hn::IfThenElseZero(here, hn::Load(f, list.z + i));
      sx = hn::Add(sx, x);
      sy = hn::Add(sy, y);
      sz = hn::Add(sz, z);
      xx = hn::MulAdd(x, x, xx);
      xy = hn::MulAdd(x, y, xy);
      xz = hn::MulAdd(x, z, xz);
      yy = hn::MulAdd(y, y, yy);
      yz = hn::MulAdd(y, z, yz);
      zz = hn::MulAdd(z, z, zz);
    }
    const auto sum = [&](V v) HWY_ATTR {
      return static_cast<double>(hn::GetLane(hn::SumOfLanes(f, v)));
    };
    sums.count += static_cast<double>(end - chunk);
    sums.first += Point(sum(sx), sum(sy), sum(sz));
    sums.xx += sum(xx);
    sums.xy += sum(xy);
    sums.xz += sum(xz);
    sums.yy += sum(yy);
    sums.yz += sum(yz);
    sums.zz += sum(zz);
  }
}

void
order(PointList& list,
      PointList& spare,
      const LadderScale* scales,
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
    // The last vector is written whole; the points of larger scales stand behind it.
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
        put(f, x, mask, to.x + at);
        put(f, y, mask, to.y + at);
        put(f, z, mask, to.z + at);
        put(f, h, mask, to.h + at);
        put(u, id, hn::RebindMask(u, mask), to.id + at);
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

void
sharpen(PointList& list,
        float reach,
        const ExactSource& source,
        float core,
        PointList& near)
{
  const F f;
  const V limit = constant(reach);
  for (std::size_t i = 0; i < list.size; i += hn::Lanes(f)) {
    const auto close =
        hn::And(present(list, i), hn::Le(hn::Load(f, list.h + i), limit));
    if (hn::AllFalse(f, close))
      continue;
    for (std::uint32_t bits = bitsOf(close), lane = 0; bits != 0; bits >>= 1, ++lane) {
      if ((bits & 1) == 0)
        continue;
      const std::size_t at = i + lane;
      const std::uint32_t id = list.id[at];
      const auto local = [&](const double* values, std::size_t axis) {
        return static_cast<float>((values[id] - source.origin[axis]) * source.scale -
                                  source.center[axis]);
      };
      const float x = local(source.x, 0), y = local(source.y, 1),
                  z = local(source.z, 2);
      list.x[at] = x;
      list.y[at] = y;
      list.z[at] = z;
      list.h[at] = x * x + y * y + z * z;
      if (list.h[at] > core)
        continue;
      near.extend(1);
      near.x[near.size] = x;
      near.y[near.size] = y;
      near.z[near.size] = z;
      near.id[near.size++] = id;
    }
  }
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
