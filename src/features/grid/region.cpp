// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "region.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace linelet::grid {

void
RegionGatherer::operator()(const BlockFrame::Cell& cell,
                           const Point& origin,
                           const Points& queries,
                           double reach,
                           PointList& region)
{
  Point low = queries.front(), high = low;
  for (const Point& query : queries) {
    low = low.cwiseMin(query);
    high = high.cwiseMax(query);
  }
  const Box box{toFloat(low), toFloat(high)};

  // Blocks that follow each other along x are one run of points.
  std::array<std::pair<std::size_t, std::size_t>, 9> runs;
  std::size_t count = 0, points = 0;
  for (std::int64_t z = std::max<std::int64_t>(cell[2] - 1, 0); z <= cell[2] + 1; ++z)
    for (std::int64_t y = std::max<std::int64_t>(cell[1] - 1, 0); y <= cell[1] + 1;
         ++y) {
      const std::uint64_t last = frame_.key({cell[0] + 1, y, z});
      std::size_t block = surface_.lowerBound(
          frame_.key({std::max<std::int64_t>(cell[0] - 1, 0), y, z}), cursors_[count]);
      cursors_[count] = block;
      const std::size_t begin = surface_.begin(block);
      while (block < surface_.blocks() && surface_.key(block) <= last)
        ++block;
      runs[count] = {begin, surface_.begin(block)};
      points += runs[count].second - begin;
      ++count;
    }
  region.reserve(points);
  region.size = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (runs[i].first < runs[i].second)
      gather_({surface_.coordinate(0),
               surface_.coordinate(1),
               surface_.coordinate(2),
               runs[i].first,
               runs[i].second,
               {origin.x(), origin.y(), origin.z()},
               1 / unit_},
              box,
              static_cast<float>(reach * reach),
              region);
  region.pad();
}

} // namespace linelet::grid
