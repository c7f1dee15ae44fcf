// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sums over pairs of candidates and queries, a query per lane. Included once per
// instruction set, so it has a guard that toggles.

#if defined(LINELET_GRID_MULTI_SCALE_PAIRS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_MULTI_SCALE_PAIRS_INL
#undef LINELET_GRID_MULTI_SCALE_PAIRS_INL
#else
#define LINELET_GRID_MULTI_SCALE_PAIRS_INL
#endif

#include <hwy/highway.h>

#include "multi_scale_kernels.h"
#include "multi_scale_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

void
coincident(const PointList& list,
           float tolerance,
           const LeafQueries& queries,
           Lanes<float>& counts)
{
  const F f;
  const Chunk points(list, 0, list.size, false);
  for (std::size_t q = 0; q < leaf_queries; q += hn::Lanes(f)) {
    const QueryVector query(queries, q);
    V count = hn::Load(f, counts.lane + q);
    for (std::size_t c = 0; c < list.size; ++c)
      count = hn::Add(
          count,
          hn::IfThenElseZero(hn::Le(query.squaredFrom(points, c), constant(tolerance)),
                             constant(1)));
    hn::Store(count, f, counts.lane + q);
  }
}

/** \brief Notes queries for which rounding may decide. */
template <class Mask>
HWY_INLINE void
doubt(Mask mask,
      std::size_t place,
      std::uint16_t scale,
      std::size_t q,
      std::vector<Doubt>& doubts)
{
  if (HWY_LIKELY(hn::AllFalse(F(), mask)))
    return;
  doubts.push_back({static_cast<std::uint32_t>(place),
                    scale,
                    static_cast<std::uint16_t>(bitsOf(mask) << q)});
}

void
constPairs(const PointList& list,
           const LeafQueries& queries,
           const LeafScale& scale,
           std::uint16_t scale_number,
           ScaleSums& sums,
           std::vector<Doubt>& doubts)
{
  const F f;
  for (std::size_t begin = 0; begin < list.size; begin += chunk_points) {
    const std::size_t end = HWY_MIN(begin + chunk_points, list.size);
    const Chunk chunk(list, begin, end, false);
    for (std::size_t q = 0; q < leaf_queries; q += hn::Lanes(f)) {
      const QueryVector query(queries, q);
      const V low = constant(scale.band.low), high = constant(scale.band.high);
      PairSums part;
      if (scale.relative) {
        for (std::size_t c = 0; c < chunk.size; ++c) {
          const V squared = query.squaredFrom(chunk, c);
          const auto within = hn::Le(squared, low);
          doubt(hn::AndNot(within, hn::Le(squared, high)),
                begin + c,
                scale_number,
                q,
                doubts);
          part.addAbout(hn::IfThenElseZero(within, constant(1)), chunk, c, query);
        }
      }
      else {
        // |p - q|^2 <= r^2 as |p|^2 - 2 p.q <= r^2 - |q|^2.
        const V square = hn::MulAdd(
            query.x, query.x, hn::MulAdd(query.y, query.y, hn::Mul(query.z, query.z)));
        const V least = hn::Sub(low, square), most = hn::Sub(high, square);
        const V qx = hn::Add(query.x, query.x), qy = hn::Add(query.y, query.y),
                qz = hn::Add(query.z, query.z);
        const float* const h = list.h + begin;
        for (std::size_t c = 0; c < chunk.size; ++c) {
          V s = hn::NegMulAdd(qx, constant(chunk.x[c]), constant(h[c]));
          s = hn::NegMulAdd(qy, constant(chunk.y[c]), s);
          s = hn::NegMulAdd(qz, constant(chunk.z[c]), s);
          const auto within = hn::Le(s, least);
          doubt(
              hn::AndNot(within, hn::Le(s, most)), begin + c, scale_number, q, doubts);
          part.addMasked(within, chunk, c);
        }
      }
      part.addTo(sums, q);
    }
  }
}

/** \brief Sums of a chunk at one scale, by weights already computed.
 * \tparam relative: to the queries, see LeafScale
 * \tparam second: with second moments
 * \tparam open: not all points are neighbors of all queries */
template <bool relative, bool second, bool open>
void
sumPairs(const Chunk& chunk,
         std::size_t size,
         const float* squared,
         const float* weights,
         const QueryVector& query,
         const LeafScale& scale,
         std::uint16_t scale_number,
         std::size_t q,
         ScaleSums& sums,
         std::vector<Doubt>& doubts)
{
  const F f;
  const std::size_t lanes = hn::Lanes(f);
  const V low = constant(scale.band.low), high = constant(scale.band.high);
  PairSums part;
  for (std::size_t c = 0; c < size; ++c) {
    V w = hn::Load(f, weights + c * lanes);
    if constexpr (open) {
      const V s = hn::Load(f, squared + c * lanes);
      const auto within = hn::Le(s, low);
      doubt(hn::AndNot(within, hn::Le(s, high)),
            chunk.first + c,
            scale_number,
            q,
            doubts);
      w = hn::IfThenElseZero(within, w);
      part.found = hn::IfThenElse(within, hn::Add(part.found, constant(1)), part.found);
    }
    if constexpr (relative)
      part.addAbout(w, chunk, c, query);
    else
      part.template add<second>(w, chunk, c);
  }
  if constexpr (!open)
    part.found = constant(static_cast<float>(size));
  part.addTo(sums, q);
}

void
weightedPairs(const PointList& list,
              const std::size_t* ends,
              const LeafQueries& queries,
              const LeafScale* scales,
              std::size_t count,
              const SweepWeight& weight,
              bool first_only,
              ScaleSums* sums,
              std::vector<Doubt>& doubts)
{
  const F f;
  const std::size_t lanes = hn::Lanes(f);
  const PairWeighting weighting(weight);
  PairBuffer squared, distance, weights;
  const auto certain =
      first_only ? sumPairs<false, false, false> : sumPairs<false, true, false>;
  const auto open =
      first_only ? sumPairs<false, false, true> : sumPairs<false, true, true>;
  std::size_t smallest = 0;
  for (std::size_t begin = 0; begin < list.size; begin += chunk_points) {
    const std::size_t end = HWY_MIN(begin + chunk_points, list.size);
    const Chunk chunk(list, begin, end, !first_only);
    while (ends[smallest] <= begin)
      ++smallest;
    const float nearest = smallest > 0 ? scales[smallest - 1].radius : 0;
    std::size_t largest = smallest; // within reach of which all points lie
    while (ends[largest] < end)
      ++largest;
    const float farthest = scales[largest].far;
    for (std::size_t q = 0; q < leaf_queries; q += lanes) {
      const QueryVector query(queries, q);
      for (std::size_t c = 0; c < chunk.size; ++c) {
        const V s = query.squaredFrom(chunk, c);
        hn::Store(s, f, squared.value + c * lanes);
        if (weighting.needsDistances())
          hn::Store(hn::Sqrt(s), f, distance.value + c * lanes);
      }
      for (std::size_t k = smallest; k < count; ++k) {
        const std::size_t size = HWY_MIN(end, ends[k]) - begin;
        weighting.fill(squared,
                       distance,
                       nearest * nearest,
                       1 / scales[k].radius,
                       size * lanes,
                       weights);
        const auto sum = scales[k].relative          ? sumPairs<true, true, true>
                         : farthest < scales[k].near ? certain
                                                     : open;
        sum(chunk,
            size,
            squared.value,
            weights.value,
            query,
            scales[k],
            static_cast<std::uint16_t>(k),
            q,
            sums[k],
            doubts);
      }
    }
  }
}

template <class W>
HWY_INLINE void
centeredPairsOf(const W& weight,
                const PointList& list,
                std::size_t end,
                const LeafQueries& queries,
                const LeafScale& scale,
                const LeafQueries& centers,
                ScaleSums& sums)
{
  const V low = constant(scale.band.low);
  for (std::size_t begin = 0; begin < end; begin += chunk_points) {
    const Chunk chunk(list, begin, HWY_MIN(begin + chunk_points, end), false);
    for (std::size_t q = 0; q < leaf_queries; q += hn::Lanes(F())) {
      const QueryVector query(queries, q), center(centers, q);
      PairSums part;
      for (std::size_t c = 0; c < chunk.size; ++c) {
        const auto within = hn::Le(query.squaredFrom(chunk, c), low);
        const V w = hn::IfThenElseZero(within, weight(center.squaredFrom(chunk, c)));
        part.addAbout(w, chunk, c, center);
      }
      part.addTo(sums, q);
    }
  }
}

void
centeredPairs(const PointList& list,
              std::size_t end,
              const LeafQueries& queries,
              const LeafScale& scale,
              const LeafQueries& centers,
              const SweepWeight& weight,
              ScaleSums& sums)
{
  const float inverse = 1 / scale.radius, factor = inverse * inverse;
  withWeight(weight.weighting, [&](const auto& direct) HWY_ATTR {
    // Neighbors can be farther than the radius from the center.
    if (!withTableOnly(weight, factor, [&](const auto& table) HWY_ATTR {
          const V end_of_table = constant(scale.radius * scale.radius);
          const auto w = [&](V squared) HWY_ATTR {
            const auto beyond = hn::Ge(squared, end_of_table);
            const V value = table(squared);
            if (HWY_LIKELY(hn::AllFalse(F(), beyond)))
              return value;
            return hn::IfThenElse(
                beyond, direct(hn::Mul(squared, constant(factor))), value);
          };
          centeredPairsOf(w, list, end, queries, scale, centers, sums);
        }))
      centeredPairsOf(
          [&](V squared)
              HWY_ATTR { return direct(hn::Mul(squared, constant(factor))); },
          list,
          end,
          queries,
          scale,
          centers,
          sums);
  });
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
