// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sums of moments over lists. Included once per instruction set, so it has a guard that
// toggles.

#if defined(LINELET_GRID_SUMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_SUMS_INL
#undef LINELET_GRID_SUMS_INL
#else
#define LINELET_GRID_SUMS_INL
#endif

#include <array>

#include <hwy/highway.h>

#include "sweep_kernels.h"
#include "table-inl.h"
#include "weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

/** \brief Vectors summed in float before the sum continues in double: the error of a
 * lane stays below 64 half units in the last place. */
constexpr std::size_t chunk_vectors = 64;

/** \brief Moments of a chunk, in float, lane by lane. */
template <bool with_first>
struct ChunkSums {
  V sx, sy, sz, xx, xy, xz, yy, yz, zz, weight;
  std::size_t count = 0;

  HWY_INLINE
  ChunkSums() { sx = sy = sz = xx = xy = xz = yy = yz = zz = weight = hn::Zero(F()); }

  /** \brief Weight 1 for the lanes of \a mask, 0 for the others. */
  template <class Mask>
  HWY_INLINE void
  addMasked(Mask mask, V x, V y, V z)
  {
    // With registers for masks, sums are masked at no cost; without, nine blends cost
    // more than the three that make points weightless.
    constexpr bool mask_sums = HWY_TARGET <= HWY_AVX3;
    const auto kept = [&](V sum, V s) HWY_ATTR {
      return mask_sums ? hn::IfThenElse(mask, sum, s) : sum;
    };
    const auto factor = [&](V v) HWY_ATTR {
      return mask_sums ? v : hn::IfThenElseZero(mask, v);
    };
    const auto sum = [&](V& s, V a, V b) HWY_ATTR { s = kept(hn::MulAdd(a, b, s), s); };
    const V mx = factor(x), my = factor(y), mz = factor(z);
    sx = kept(hn::Add(sx, mx), sx);
    sy = kept(hn::Add(sy, my), sy);
    sz = kept(hn::Add(sz, mz), sz);
    sum(xx, mx, x);
    sum(xy, mx, y);
    sum(xz, mx, z);
    sum(yy, my, y);
    sum(yz, my, z);
    sum(zz, mz, z);
    count += hn::CountTrue(F(), mask);
  }

  HWY_INLINE void
  addWeighted(V w, V x, V y, V z)
  {
    const V wx = hn::Mul(w, x), wy = hn::Mul(w, y), wz = hn::Mul(w, z);
    weight = hn::Add(weight, w);
    if constexpr (with_first) {
      sx = hn::Add(sx, wx);
      sy = hn::Add(sy, wy);
      sz = hn::Add(sz, wz);
    }
    xx = hn::MulAdd(wx, x, xx);
    xy = hn::MulAdd(wx, y, xy);
    xz = hn::MulAdd(wx, z, xz);
    yy = hn::MulAdd(wy, y, yy);
    yz = hn::MulAdd(wy, z, yz);
    zz = hn::MulAdd(wz, z, zz);
  }
};

HWY_INLINE double
sumOf(V v)
{
  return static_cast<double>(hn::GetLane(hn::SumOfLanes(F(), v)));
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE std::array<double, 4>
sumsOf(V a, V b, V c, V d)
{
  return {sumOf(a), sumOf(b), sumOf(c), sumOf(d)};
}

#else

/** \brief The sum of all blocks of four lanes. */
template <class Tag>
HWY_INLINE hn::Vec<hn::Full128<float>>
sumOfBlocks(Tag tag, hn::Vec<Tag> v)
{
  if constexpr (hn::MaxLanes(Tag()) == 4)
    return v;
  else {
    const hn::Half<Tag> half;
    return sumOfBlocks(half, hn::Add(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
  }
}

/** \brief The sums of the lanes of four vectors: they are turned into columns as they
 * are added, in fewer steps than four separate sums. */
HWY_INLINE std::array<double, 4>
sumsOf(V a, V b, V c, V d)
{
  const F f;
  const hn::Repartition<double, F> pairs;
  const V ab = hn::Add(hn::InterleaveLower(f, a, b), hn::InterleaveUpper(f, a, b));
  const V cd = hn::Add(hn::InterleaveLower(f, c, d), hn::InterleaveUpper(f, c, d));
  const auto p = hn::BitCast(pairs, ab), q = hn::BitCast(pairs, cd);
  const V abcd = hn::Add(hn::BitCast(f, hn::InterleaveLower(pairs, p, q)),
                         hn::BitCast(f, hn::InterleaveUpper(pairs, p, q)));
  HWY_ALIGN std::array<float, 4> sums;
  hn::Store(sumOfBlocks(f, abcd), hn::Full128<float>(), sums.data());
  return {sums[0], sums[1], sums[2], sums[3]};
}

#endif

/** \brief The sum of chunks, in double. */
template <bool with_first>
struct Sums {
  Moments total;

  HWY_INLINE void
  add(const ChunkSums<with_first>& part)
  {
    const auto [xx, xy, xz, yy] = sumsOf(part.xx, part.xy, part.xz, part.yy);
    total.xx += xx;
    total.xy += xy;
    total.xz += xz;
    total.yy += yy;
    const V last = with_first ? part.sx : hn::Zero(F());
    const auto [yz, zz, weight, x] = sumsOf(part.yz, part.zz, part.weight, last);
    total.yz += yz;
    total.zz += zz;
    total.count += static_cast<double>(part.count) + weight;
    if constexpr (with_first)
      total.first += Point(x, sumOf(part.sy), sumOf(part.sz));
  }

  HWY_INLINE void
  addTo(Moments& sums) const
  {
    sums += total;
  }
};

HWY_INLINE V
squareOf(V x, V y, V z)
{
  return hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
}

/** \brief |p - q|^2 <= r^2 as |p|^2 - 2 p.q <= r^2 - |q|^2: three steps from |p|^2. */
struct BandAround {
  V x, y, z, low, high;

  HWY_INLINE
  BandAround() = default;

  HWY_INLINE explicit BandAround(const BandedQuery& query)
  {
    const auto [qx, qy, qz] = query.at;
    const float square = qx * qx + qy * qy + qz * qz;
    x = constant(2 * qx);
    y = constant(2 * qy);
    z = constant(2 * qz);
    low = constant(query.band.low - square);
    high = constant(query.band.high - square);
  }

  /** \brief What lies between low and high in the band. */
  HWY_INLINE V
  operator()(V px, V py, V pz, V square) const
  {
    return hn::NegMulAdd(z, pz, hn::NegMulAdd(y, py, hn::NegMulAdd(x, px, square)));
  }
};

HWY_INLINE bool
constSumsOf(const PointList& list, const BandAround& around, Moments& sums)
{
  const F f;
  const std::size_t lanes = hn::Lanes(f);
  Sums<true> total;
  auto doubtful = hn::FirstN(f, 0);
  for (std::size_t chunk = 0; chunk < list.size; chunk += chunk_vectors * lanes) {
    const std::size_t end = HWY_MIN(chunk + chunk_vectors * lanes, list.size);
    ChunkSums<true> part;
    for (std::size_t i = chunk; i < end; i += lanes) {
      const V x = hn::Load(f, list.x + i), y = hn::Load(f, list.y + i),
              z = hn::Load(f, list.z + i);
      const V s = around(x, y, z, hn::Load(f, list.h + i));
      const auto within = hn::Le(s, around.low);
      part.addMasked(within, x, y, z);
      doubtful = hn::Or(doubtful, hn::AndNot(within, hn::Le(s, around.high)));
    }
    total.add(part);
  }
  total.addTo(sums);
  return !hn::AllFalse(f, doubtful);
}

std::uint32_t
constSums(const PointList& list,
          const BandedQuery* queries,
          std::size_t count,
          Moments* sums)
{
  std::uint32_t doubts = 0;
  for (std::size_t q = 0; q < count; ++q)
    doubts |= (constSumsOf(list, BandAround(queries[q]), sums[q]) ? 1U : 0U) << q;
  return doubts;
}

/** \brief A vector of points relative to a query, and their weights. */
struct Weighed {
  V w, x, y, z;
};

/** \brief Sums over vectors at(0), at(lanes), ... below \a end. A weight is a long
 * chain of operations: it is computed one vector ahead of the sums.
 * \param part sums that continue in float up to the allowed number */
template <class At>
HWY_INLINE void
sumAhead(std::size_t end, const At& at, ChunkSums<false>& part, Sums<false>& total)
{
  const std::size_t lanes = hn::Lanes(F());
  for (std::size_t chunk = 0; chunk < end; chunk += chunk_vectors * lanes) {
    if (chunk > 0) {
      total.add(part);
      part = ChunkSums<false>();
    }
    const std::size_t stop = HWY_MIN(chunk + chunk_vectors * lanes, end);
    Weighed v = at(chunk);
    for (std::size_t i = chunk + lanes; i < stop; i += lanes) {
      const Weighed next = at(i);
      part.addWeighted(v.w, v.x, v.y, v.z);
      v = next;
    }
    part.addWeighted(v.w, v.x, v.y, v.z);
  }
}

template <class W>
HWY_INLINE Found
weightedSumsOf(const W& weight, const WeightedLists& lists, Moments& sums)
{
  const F f;
  const std::size_t lanes = hn::Lanes(f);
  Sums<false> total;
  ChunkSums<false> part;

  const PointList& certain = lists.certain;
  const V px = constant(lists.certain_query[0]), py = constant(lists.certain_query[1]),
          pz = constant(lists.certain_query[2]);
  const auto ofCertain = [&](V x, V y, V z) HWY_ATTR {
    Weighed v;
    v.x = hn::Sub(x, px);
    v.y = hn::Sub(y, py);
    v.z = hn::Sub(z, pz);
    v.w = weight.far(squareOf(v.x, v.y, v.z));
    return v;
  };
  const std::size_t rest = certain.size % lanes, whole = certain.size - rest;
  sumAhead(
      whole,
      [&](std::size_t i) HWY_ATTR {
        return ofCertain(hn::Load(f, certain.x + i),
                         hn::Load(f, certain.y + i),
                         hn::Load(f, certain.z + i));
      },
      part,
      total);
  if (rest > 0) {
    const auto real = hn::FirstN(f, rest);
    const Weighed v = ofCertain(hn::MaskedLoad(real, f, certain.x + whole),
                                hn::MaskedLoad(real, f, certain.y + whole),
                                hn::MaskedLoad(real, f, certain.z + whole));
    part.addWeighted(hn::IfThenElseZero(real, v.w), v.x, v.y, v.z);
  }

  const PointList& list = lists.doubtful;
  const auto& [at, band] = lists.query;
  const V qx = constant(at[0]), qy = constant(at[1]), qz = constant(at[2]);
  const V low = constant(band.low), high = constant(band.high);
  std::size_t found = certain.size;
  auto doubtful = hn::FirstN(f, 0);
  sumAhead(
      list.size,
      [&](std::size_t i) HWY_ATTR {
        Weighed v;
        v.x = hn::Sub(hn::Load(f, list.x + i), qx);
        v.y = hn::Sub(hn::Load(f, list.y + i), qy);
        v.z = hn::Sub(hn::Load(f, list.z + i), qz);
        const V squared = squareOf(v.x, v.y, v.z);
        const auto within = hn::Le(squared, low);
        doubtful = hn::Or(doubtful, hn::AndNot(within, hn::Le(squared, high)));
        v.w = hn::IfThenElseZero(within, weight(squared));
        found += hn::CountTrue(f, within);
        return v;
      },
      part,
      total);
  total.add(part);
  total.addTo(sums);
  return {found, !hn::AllFalse(f, doubtful)};
}

Found
weightedSums(const WeightedLists& lists,
             const SweepWeight& weight,
             float scale,
             Moments& sums)
{
  Found found{};
  withTable(weight, scale, [&](const auto& w) HWY_ATTR {
    found = weightedSumsOf(w, lists, sums);
  });
  return found;
}

template <class W>
HWY_INLINE void
momentsAroundOf(const W& weight,
                const PointList& list,
                const Float3& center,
                float scale,
                Moments& sums)
{
  const F f;
  const std::size_t lanes = hn::Lanes(f);
  const V cx = constant(center[0]), cy = constant(center[1]), cz = constant(center[2]);
  const V factor = constant(scale);
  Sums<true> total;
  for (std::size_t chunk = 0; chunk < list.size; chunk += chunk_vectors * lanes) {
    const std::size_t end = HWY_MIN(chunk + chunk_vectors * lanes, list.size);
    ChunkSums<true> part;
    for (std::size_t i = chunk; i < end; i += lanes) {
      const V dx = hn::Sub(hn::Load(f, list.x + i), cx);
      const V dy = hn::Sub(hn::Load(f, list.y + i), cy);
      const V dz = hn::Sub(hn::Load(f, list.z + i), cz);
      const V squared = squareOf(dx, dy, dz);
      // Padding is far outside; what lies there has no weight.
      const auto real = hn::Lt(squared, constant(1e20F));
      part.addWeighted(
          hn::IfThenElseZero(real, weight(hn::Mul(squared, factor))), dx, dy, dz);
    }
    total.add(part);
  }
  total.addTo(sums);
}

void
momentsAround(const PointList& list,
              const Float3& center,
              const Weighting& weighting,
              float scale,
              Moments& sums)
{
  withWeight(weighting, [&](const auto& weight) HWY_ATTR {
    momentsAroundOf(weight, list, center, scale, sums);
  });
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
