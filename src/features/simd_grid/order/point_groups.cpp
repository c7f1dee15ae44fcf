// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "point_groups.h"

#include <algorithm>
#include <cmath>

namespace linelet::grid {

namespace {

void
measure(const BlockOrder& order, PointGroup& group)
{
  const std::size_t end = group.begin + group.size;
  for (std::size_t sorted_index = group.begin; sorted_index < end; ++sorted_index)
    group.center += order.point(sorted_index) - order.point(group.begin);
  group.center = order.point(group.begin) + group.center / group.size;
  double squared = 0;
  for (std::size_t sorted_index = group.begin; sorted_index < end; ++sorted_index) {
    const Point offset = order.point(sorted_index) - group.center;
    squared = std::max(squared, offset.squaredNorm());
    group.about.add(1, offset);
  }
  group.radius = std::sqrt(squared);
}

} // namespace

PointGroups::PointGroups(const BlockOrder& order, int threads)
{
  begin_.push_back(0);
  for (std::size_t block = 0; block < order.blocks(); ++block) {
    addGroups(order.begin(block), order.begin(block + 1));
    begin_.push_back(groups_.size());
  }
  const auto count = static_cast<std::ptrdiff_t>(groups_.size());
#pragma omp parallel for num_threads(threads)
  for (std::ptrdiff_t i = 0; i < count; ++i)
    measure(order, groups_[static_cast<std::size_t>(i)]);
}

void
PointGroups::addGroups(std::size_t begin, std::size_t end)
{
  if (end - begin > most_points) {
    const std::size_t middle = begin + BlockOrder::half(end - begin);
    addGroups(begin, middle);
    addGroups(middle, end);
    return;
  }
  groups_.push_back({static_cast<std::uint32_t>(begin),
                     static_cast<std::uint32_t>(end - begin),
                     Point::Zero(),
                     0,
                     {}});
}

} // namespace linelet::grid
