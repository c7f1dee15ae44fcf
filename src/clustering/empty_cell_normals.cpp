// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "empty_cell_normals.h"

#include <cstddef>

#include <linelet/tensor/eigen_analysis.h>

namespace linelet::clustering {

namespace {

constexpr std::int32_t reach = 2;  ///< cells; with 1, there are only 26 directions
constexpr double one_sided = 0.25; ///< of the mean direction; half of a half space's

bool
isWithin(const Cell& cell, const Cell& cells)
{
  for (std::size_t a = 0; a < 3; ++a)
    if (cell[a] < 0 || cell[a] >= cells[a])
      return false;
  return true;
}

Point
normalOf(const Representative& of,
         const CellDirectory& directory,
         const CellFrame& frame,
         const std::vector<char>& is_filled)
{
  SymmetricTensor moments;
  Point sum = Point::Zero();
  double count = 0;
  for (std::int32_t dx = -reach; dx <= reach; ++dx)
    for (std::int32_t dy = -reach; dy <= reach; ++dy)
      for (std::int32_t dz = -reach; dz <= reach; ++dz) {
        const Cell cell = {of.cell[0] + dx, of.cell[1] + dy, of.cell[2] + dz};
        // What is out of a camera's view is unknown; what is outside the box is empty.
        if (frame.perspective && !isWithin(cell, frame.cells))
          continue;
        const Index slot = directory.find(cell);
        if (slot != CellDirectory::none && is_filled[slot] != 0)
          continue;
        const Point way = (frame.middle(cell) - frame.middle(of.cell)).normalized();
        moments.add(1, way);
        sum += way;
        ++count;
      }
  if (count == 0)
    return Point::Zero();
  // The directions of a half space have a mean of 1/2; those on both sides of a wall
  // cancel, and only their axis is left.
  if (sum.norm() > one_sided * count)
    return sum.normalized();
  const Point axis = eigenAnalysis(moments).major();
  return axis.dot(sum) < 0 ? -axis : axis;
}

} // namespace

Points
emptyCellNormals(const std::vector<Representative>& representatives,
                 const CellDirectory& directory,
                 const CellFrame& frame,
                 const std::vector<char>& is_filled,
                 int threads)
{
  Points normals(representatives.size());
#pragma omp parallel for num_threads(threads) schedule(static)
  for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(normals.size()); ++k) {
    const auto i = static_cast<std::size_t>(k);
    normals[i] = normalOf(representatives[i], directory, frame, is_filled);
  }
  return normals;
}

} // namespace linelet::clustering
