// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/terrain/continue_ground.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <Eigen/Dense>

#include "powerline/terrain/ground_raster.h"

namespace linelet::powerline {

namespace {

constexpr int window = 3;        // cells on each side, of the terrain beside a cell
constexpr int least_cells = 8;   // there, to determine its slope
constexpr double deviations = 3; // of the terrain from its plane
constexpr int most_rounds = 2 * largest_opening_radius; // of a cell each

/** \brief The plane of the terrain around a cell, least squares. */
struct Plane {
  bool known = false;
  double height = 0; ///< at the cell
  double noise = 0;  ///< root mean square of the distances from the plane
};

Plane
planeAround(
    const std::vector<float>& ground, int columns, int rows, int column, int row)
{
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();
  double total = 0;
  int count = 0;
  for (int r = std::max(0, row - window); r <= std::min(rows - 1, row + window); ++r)
    for (int c = std::max(0, column - window);
         c <= std::min(columns - 1, column + window);
         ++c) {
      const float height =
          ground[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) +
                 static_cast<std::size_t>(c)];
      if (std::isnan(height))
        continue;
      const Eigen::Vector3d v(1, c - column, r - row);
      squares += v * v.transpose();
      sums += height * v;
      total += double(height) * height;
      ++count;
    }
  Plane plane;
  // Cells in a row do not determine the slope across it.
  const Eigen::LDLT<Eigen::Matrix3d> solver(squares);
  if (count < least_cells || solver.vectorD().minCoeff() < 1)
    return plane;
  const Eigen::Vector3d fit = solver.solve(sums);
  plane.known = true;
  plane.height = fit[0];
  plane.noise = std::sqrt(std::max(0.0, (total - fit.dot(sums)) / (count - 3)));
  return plane;
}

} // namespace

void
continueGround(std::vector<float>& ground,
               const std::vector<float>& lowest,
               int columns,
               int rows,
               const ProgressMonitor* monitor)
{
  const auto at = [columns](int c, int r) {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(c);
  };
  using Cell = std::pair<int, int>;
  const auto isOpen = [&](int c, int r) {
    return std::isnan(ground[at(c, r)]) && !std::isnan(lowest[at(c, r)]);
  };
  std::vector<Cell> open; // beside new terrain
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      if (isOpen(c, r))
        open.emplace_back(c, r);
  std::vector<std::int8_t> round_of(ground.size(), -1); // in which a cell is open
  for (int round = 0; round < most_rounds && !open.empty(); ++round) {
    throwIfCanceled(monitor);
    std::vector<Cell> accepted;
    for (const auto& [c, r] : open) {
      const Plane plane = planeAround(ground, columns, rows, c, r);
      if (plane.known && std::abs(lowest[at(c, r)] - plane.height) <=
                             terrain_noise + deviations * plane.noise)
        accepted.emplace_back(c, r);
    }
    // All at once, so that their order does not matter.
    for (const auto& [c, r] : accepted)
      ground[at(c, r)] = lowest[at(c, r)];
    open.clear();
    for (const auto& [column, row] : accepted)
      for (int r = std::max(0, row - window); r <= std::min(rows - 1, row + window);
           ++r)
        for (int c = std::max(0, column - window);
             c <= std::min(columns - 1, column + window);
             ++c)
          if (isOpen(c, r) && round_of[at(c, r)] != round) {
            round_of[at(c, r)] = static_cast<std::int8_t>(round);
            open.emplace_back(c, r);
          }
  }
}

} // namespace linelet::powerline
