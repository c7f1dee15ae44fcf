// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "region.h"

#include <algorithm>
#include <cstdint>

namespace linelet::grid {

std::array<BlocksAround::Run, 9>
BlocksAround::operator()(const BlockFrame::Cell& cell)
{
  std::array<Run, 9> runs{};
  const std::int64_t x = std::max<std::int64_t>(cell[0] - 1, 0);
  std::size_t count = 0;
  for (std::int64_t z = std::max<std::int64_t>(cell[2] - 1, 0); z <= cell[2] + 1; ++z)
    for (std::int64_t y = std::max<std::int64_t>(cell[1] - 1, 0); y <= cell[1] + 1;
         ++y) {
      const std::uint64_t last = frame_.key({cell[0] + 1, y, z});
      std::size_t block = order_.lowerBound(frame_.key({x, y, z}), cursors_[count]);
      cursors_[count] = block;
      const std::size_t begin = block;
      while (block < order_.blocks() && order_.key(block) <= last)
        ++block;
      runs[count++] = {begin, block};
    }
  return runs;
}

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

  const auto runs = around_(cell);
  std::size_t points = 0;
  for (const auto& [first, last] : runs)
    points += surface_.begin(last) - surface_.begin(first);
  region.reserve(points);
  region.size = 0;
  for (const auto& [first, last] : runs)
    if (first < last)
      gather_({surface_.coordinate(0),
               surface_.coordinate(1),
               surface_.coordinate(2),
               surface_.begin(first),
               surface_.begin(last),
               {origin.x(), origin.y(), origin.z()},
               1 / unit_},
              box,
              static_cast<float>(reach * reach),
              region);
  region.pad();
}

} // namespace linelet::grid
