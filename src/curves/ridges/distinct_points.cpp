// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "distinct_points.h"

#include <algorithm>

#include "occupied_cells.h"

namespace linelet {

namespace {

constexpr std::size_t most_in_cell = 100;

} // namespace

Points
pointsAt(const Points& points, const Indices& indices)
{
  Points result;
  result.reserve(indices.size());
  for (const Index i : indices)
    result.push_back(points[i]);
  return result;
}

Indices
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
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

Indices
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
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

Points
onePerCell(const Points& points, double size)
{
  const OccupiedCells cells = occupiedCells(points, size);
  Indices chosen;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Point mean = Point::Zero();
    for (std::size_t k = cells.begin[c]; k < cells.begin[c + 1]; ++k)
      mean += points[cells.indices[k]];
    mean /= static_cast<double>(cells.begin[c + 1] - cells.begin[c]);
    Index nearest = cells.indices[cells.begin[c]];
    for (std::size_t k = cells.begin[c]; k < cells.begin[c + 1]; ++k)
      if ((points[cells.indices[k]] - mean).squaredNorm() <
          (points[nearest] - mean).squaredNorm())
        nearest = cells.indices[k];
    chosen.push_back(nearest);
  }
  std::sort(chosen.begin(), chosen.end());
  return pointsAt(points, chosen);
}

} // namespace linelet
