// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include "block_sweep.h"

namespace linelet::grid {

PointDistributionTensor
BlockSweep::inDouble(std::size_t query, const PointList& candidates)
{
  // In the order of the list, which is that of the places: the indices of a piece of a
  // cloud come in another order than those of the whole, and the sum would round
  // otherwise.
  offsets_.clear();
  const Point at = job_.queries.point(first_ + query);
  for (std::size_t i = 0; i < candidates.size; ++i)
    if (isNeighbor(query, candidates.id[i]))
      offsets_.push_back(job_.surface.point(candidates.id[i]) - at);
  if (offsets_.empty())
    return unknownTensor(0);
  return tensorOf(offsets_, radiusOf(query), job_.settings);
}

void
BlockSweep::write()
{
  QuerySums sums{};
  sums.count = queries_.size();
  for (std::size_t m = 0; m < sums_.size(); ++m)
    sums.moments[m] = sums_[m].data();
  for (std::size_t axis = 0; axis < 3; ++axis)
    sums.query[axis] = places_[axis].data();
  sums.found = found_.data();
  const RecordSettings settings{method_ == SweepMethod::Sums &&
                                    job_.settings.centroid == Centroid::Mean,
                                weightError(job_.settings.weighting),
                                4 * 0x1p-24 * (reach_ + 1),
                                job_.radius * job_.radius,
                                job_.settings.normalization == Normalization::Count};
  RecordLanes lanes;
  for (std::size_t first = 0; first < sums.count; first += RecordLanes::queries) {
    const std::uint32_t precise = kernels_.records(sums, settings, first, lanes);
    const std::size_t count = std::min(sums.count - first, RecordLanes::queries);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t query = first + i;
      PointDistributionTensor& record =
          job_.records[job_.queries.index(first_ + query)];
      if ((precise >> i & 1) == 0) {
        if (stopped())
          return;
        record = inDouble(query, region_);
        continue;
      }
      const auto& e = lanes.entry;
      record = {e[0][i],
                e[1][i],
                e[2][i],
                e[3][i],
                e[4][i],
                e[5][i],
                e[6][i],
                e[7][i],
                e[8][i],
                e[9][i],
                e[10][i],
                e[11][i],
                e[12][i],
                e[13][i],
                e[14][i],
                e[15][i],
                e[16][i],
                e[17][i],
                static_cast<std::uint32_t>(found_[query])};
    }
  }
}

} // namespace linelet::grid
