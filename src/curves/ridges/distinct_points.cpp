// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "distinct_points.h"

#include <algorithm>

#include "occupied_cells.h"

namespace linelet {

namespace {

constexpr std::size_t most_in_cell = 100;

Points
at(const Points& points, Indices& chosen)
{
  std::sort(chosen.begin(), chosen.end());
  Points result;
  result.reserve(chosen.size());
  for (const Index i : chosen)
    result.push_back(points[i]);
  return result;
}

} // namespace

Points
distinct(const Points& points)
{
  Indices chosen;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      chosen.push_back(static_cast<Index>(i));
  std::sort(chosen.begin(), chosen.end(), [&](Index i, Index j) {
    const Point &a = points[i], &b = points[j];
    for (int axis = 0; axis < 3; ++axis)
      if (a[axis] != b[axis])
        return a[axis] < b[axis];
    return i < j;
  });
  chosen.erase(std::unique(chosen.begin(),
                           chosen.end(),
                           [&](Index i, Index j) { return points[i] == points[j]; }),
               chosen.end());
  return at(points, chosen);
}

Points
thinned(const Points& points, double size)
{
  const OccupiedCells cells = occupiedCells(points, size);
  Indices chosen;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const std::size_t begin = cells.begin[c], count = cells.begin[c + 1] - begin;
    const std::size_t most = std::min(count, most_in_cell);
    for (std::size_t k = 0; k < most; ++k)
      chosen.push_back(cells.indices[begin + k * count / most]);
  }
  return at(points, chosen);
}

} // namespace linelet
