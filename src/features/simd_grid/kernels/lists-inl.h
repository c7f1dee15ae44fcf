// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Making lists of candidates out of others. Included once per instruction set, so it
// has a guard that toggles.

#if defined(LINELET_GRID_LISTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_LISTS_INL
#undef LINELET_GRID_LISTS_INL
#else
#define LINELET_GRID_LISTS_INL
#endif

#include <hwy/highway.h>

#include "sums-inl.h"
#include "support/append-inl.h"
#include "sweep_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

using linelet::HWY_NAMESPACE::append;

/** \brief As PointList::pad, for readers by vectors. */
HWY_INLINE void
pad(PointList& list)
{
  const F f;
  const V far = constant(PointList::far_away);
  hn::StoreU(far, f, list.x + list.size);
  hn::StoreU(far, f, list.y + list.size);
  hn::StoreU(far, f, list.z + list.size);
  hn::StoreU(constant(PointList::far_away_square), f, list.h + list.size);
}

void
gather(const Run& run, const Box& box, float reach, PointList& list)
{
  // Vectors of doubles and the same number of floats.
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, hn::ScalableTag<double>> f;
  const hn::RebindToUnsigned<decltype(f)> u;
  const std::size_t lanes = hn::Lanes(d);
  const auto scale = hn::Set(d, run.scale);
  const auto lowx = hn::Set(f, box.low[0]), highx = hn::Set(f, box.high[0]);
  const auto lowy = hn::Set(f, box.low[1]), highy = hn::Set(f, box.high[1]);
  const auto lowz = hn::Set(f, box.low[2]), highz = hn::Set(f, box.high[2]);
  const auto ox = hn::Set(d, run.origin[0]), oy = hn::Set(d, run.origin[1]),
             oz = hn::Set(d, run.origin[2]);
  const auto most = hn::Set(f, reach);
  std::size_t size = list.size;
  for (std::size_t i = run.begin; i < run.end; i += lanes) {
    const auto local = [&](const double* values, auto origin) HWY_ATTR {
      return hn::DemoteTo(f, hn::Mul(hn::Sub(hn::LoadU(d, values + i), origin), scale));
    };
    const auto x = local(run.x, ox), y = local(run.y, oy), z = local(run.z, oz);
    const auto outside = [](auto v, auto low, auto high) HWY_ATTR {
      return hn::Sub(v, hn::Min(hn::Max(v, low), high));
    };
    const auto dx = outside(x, lowx, highx), dy = outside(y, lowy, highy),
               dz = outside(z, lowz, highz);
    const auto squared = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
    auto keep = hn::Le(squared, most);
    if (i + lanes > run.end)
      keep = hn::And(keep, hn::FirstN(f, run.end - i));
    append(f, x, keep, list.x + size);
    append(f, y, keep, list.y + size);
    append(f, z, keep, list.z + size);
    const auto id = hn::Iota(u, static_cast<std::uint32_t>(i));
    append(u, id, hn::RebindMask(u, keep), list.id + size);
    size += hn::CountTrue(f, keep);
  }
  list.size = size;
}

template <bool recenter, bool sum>
HWY_INLINE void
classifyAs(const PointList& in, const Ball& ball, PointList& out, Moments* inside)
{
  const F f;
  const hn::RebindToUnsigned<F> u;
  const std::size_t lanes = hn::Lanes(f);
  const V cx = constant(ball.center[0]), cy = constant(ball.center[1]),
          cz = constant(ball.center[2]);
  const V certain = constant(ball.inside), most = constant(ball.outside);
  std::size_t size = 0;
  Sums<true> sums;
  for (std::size_t chunk = 0; chunk < in.size; chunk += chunk_vectors * lanes) {
    const std::size_t end = HWY_MIN(chunk + chunk_vectors * lanes, in.size);
    ChunkSums<true> part;
    for (std::size_t i = chunk; i < end; i += lanes) {
      const V x = hn::Load(f, in.x + i), y = hn::Load(f, in.y + i),
              z = hn::Load(f, in.z + i);
      const V dx = hn::Sub(x, cx), dy = hn::Sub(y, cy), dz = hn::Sub(z, cz);
      const V squared = squareOf(dx, dy, dz);
      auto keep = hn::Le(squared, most);
      if constexpr (sum) {
        const auto within = hn::Lt(squared, certain);
        part.addMasked(within, dx, dy, dz);
        keep = hn::AndNot(within, keep);
      }
      append(f, recenter ? dx : x, keep, out.x + size);
      append(f, recenter ? dy : y, keep, out.y + size);
      append(f, recenter ? dz : z, keep, out.z + size);
      if constexpr (recenter)
        append(f, squared, keep, out.h + size);
      append(u, hn::Load(u, in.id + i), hn::RebindMask(u, keep), out.id + size);
      size += hn::CountTrue(f, keep);
    }
    if constexpr (sum)
      sums.add(part);
  }
  out.size = size;
  pad(out);
  if constexpr (sum)
    sums.addTo(*inside);
}

void
classify(const PointList& in,
         const Ball& ball,
         bool recenter,
         PointList& out,
         Moments* inside)
{
  const bool sum = inside != nullptr && ball.inside > 0;
  if (recenter && sum)
    classifyAs<true, true>(in, ball, out, inside);
  else if (recenter)
    classifyAs<true, false>(in, ball, out, inside);
  else if (sum)
    classifyAs<false, true>(in, ball, out, inside);
  else
    classifyAs<false, false>(in, ball, out, inside);
}

template <bool recenter>
HWY_INLINE void
splitAs(const PointList& in, const Ball& ball, PointList& out, PointList& certain)
{
  const F f;
  const hn::RebindToUnsigned<F> u;
  const V cx = constant(ball.center[0]), cy = constant(ball.center[1]),
          cz = constant(ball.center[2]);
  const V near = constant(ball.near), inside = constant(ball.inside),
          most = constant(ball.outside);
  std::size_t size = 0, certain_size = certain.size;
  for (std::size_t i = 0; i < in.size; i += hn::Lanes(f)) {
    const V x = hn::Load(f, in.x + i), y = hn::Load(f, in.y + i),
            z = hn::Load(f, in.z + i);
    const V dx = hn::Sub(x, cx), dy = hn::Sub(y, cy), dz = hn::Sub(z, cz);
    const V squared = squareOf(dx, dy, dz);
    const auto within = hn::And(hn::Lt(squared, inside), hn::Ge(squared, near));
    const auto keep = hn::AndNot(within, hn::Le(squared, most));
    append(f, x, within, certain.x + certain_size);
    append(f, y, within, certain.y + certain_size);
    append(f, z, within, certain.z + certain_size);
    certain_size += hn::CountTrue(f, within);
    append(f, recenter ? dx : x, keep, out.x + size);
    append(f, recenter ? dy : y, keep, out.y + size);
    append(f, recenter ? dz : z, keep, out.z + size);
    append(u, hn::Load(u, in.id + i), hn::RebindMask(u, keep), out.id + size);
    size += hn::CountTrue(f, keep);
  }
  out.size = size;
  pad(out);
  certain.size = certain_size;
}

void
split(const PointList& in,
      const Ball& ball,
      bool recenter,
      PointList& out,
      PointList& certain)
{
  if (recenter)
    splitAs<true>(in, ball, out, certain);
  else
    splitAs<false>(in, ball, out, certain);
}

/** \brief Points relative to a query, and their position in its band. */
struct Seen {
  V dx, dy, dz, squared;
};

HWY_INLINE Seen
seen(const PointList& list, std::size_t i, V qx, V qy, V qz)
{
  const F f;
  Seen s;
  s.dx = hn::Sub(hn::Load(f, list.x + i), qx);
  s.dy = hn::Sub(hn::Load(f, list.y + i), qy);
  s.dz = hn::Sub(hn::Load(f, list.z + i), qz);
  s.squared = squareOf(s.dx, s.dy, s.dz);
  return s;
}

bool
neighbors(const PointList& list, const BandedQuery& query, PointList& out)
{
  const F f;
  const hn::RebindToUnsigned<F> u;
  const V qx = constant(query.at[0]), qy = constant(query.at[1]),
          qz = constant(query.at[2]);
  const V low = constant(query.band.low), high = constant(query.band.high);
  std::size_t size = 0;
  auto doubtful = hn::FirstN(f, 0);
  for (std::size_t i = 0; i < list.size; i += hn::Lanes(f)) {
    const Seen s = seen(list, i, qx, qy, qz);
    const auto keep = hn::Le(s.squared, low);
    doubtful = hn::Or(doubtful, hn::AndNot(keep, hn::Le(s.squared, high)));
    append(f, s.dx, keep, out.x + size);
    append(f, s.dy, keep, out.y + size);
    append(f, s.dz, keep, out.z + size);
    append(u, hn::Load(u, list.id + i), hn::RebindMask(u, keep), out.id + size);
    size += hn::CountTrue(f, keep);
  }
  out.size = size;
  pad(out);
  return !hn::AllFalse(f, doubtful);
}

template <class Distance>
HWY_INLINE void
inBandBy(
    const PointList& list, V low, V high, const Distance& distance, Indices& places)
{
  const F f;
  for (std::size_t i = 0; i < list.size; i += hn::Lanes(f)) {
    const V s = distance(i);
    const auto between = hn::AndNot(hn::Le(s, low), hn::Le(s, high));
    if (hn::AllFalse(f, between))
      continue;
    std::uint8_t bits[8 * 8] = {};
    hn::StoreMaskBits(f, between, bits);
    for (std::size_t lane = 0; lane < hn::Lanes(f); ++lane)
      if ((bits[lane / 8] >> (lane % 8) & 1) != 0)
        places.push_back(static_cast<Index>(i + lane));
  }
}

void
inBand(const PointList& list,
       const BandedQuery& query,
       bool constant_weights,
       Indices& places)
{
  const F f;
  // In exactly the steps of the sums, so that every point is in one of both.
  if (constant_weights) {
    const BandAround around(query);
    inBandBy(
        list,
        around.low,
        around.high,
        [&](std::size_t i) HWY_ATTR {
          const V x = hn::Load(f, list.x + i), y = hn::Load(f, list.y + i),
                  z = hn::Load(f, list.z + i);
          return around(x, y, z, hn::Load(f, list.h + i));
        },
        places);
    return;
  }
  const V qx = constant(query.at[0]), qy = constant(query.at[1]),
          qz = constant(query.at[2]);
  inBandBy(
      list,
      constant(query.band.low),
      constant(query.band.high),
      [&](std::size_t i) HWY_ATTR { return seen(list, i, qx, qy, qz).squared; },
      places);
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
