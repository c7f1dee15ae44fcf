// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "leaf_for_count.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "frame_around.h"

namespace linelet::clustering {

double
leafForCount(PointPasses& passes,
             const Points& points,
             const ClusterSettings& settings,
             int threads)
{
  ClusterSettings one = settings;
  one.cells = {1, 1, 1};
  const double extent =
      frameAround(points, one, 0, threads).size.maxCoeff() * (1 + 1e-9);
  const auto wanted = static_cast<double>(settings.count);
  const auto occupied = [&](double leaf) {
    const CellFrame frame = frameAround(points, settings, leaf, threads);
    CellDirectory directory(frame.cells);
    passes.fill(directory, frame);
    return static_cast<double>(std::max<std::size_t>(directory.occupied.count, 1));
  };
  // More cells than 2^40 are rejected; halving the finest of them is far from that.
  const double finest = extent / 8192;
  double coarse = extent, fine = finest;
  double few = 1, many = occupied(fine);
  if (many <= wanted)
    return fine;
  double best = coarse, nearest = wanted - 1;
  constexpr double close_enough = 0.005;
  constexpr int most_trials = 40;
  for (int trial = 0; trial < most_trials && nearest > close_enough * wanted; ++trial) {
    // On a surface the count falls with the square of the edge. Every third step
    // bisects, so that the range shrinks for any shape.
    const double part =
        trial % 3 == 2 ? 0.5 : std::log(many / wanted) / std::log(many / few);
    const double leaf = fine * std::pow(coarse / fine, std::clamp(part, 0.02, 0.98));
    const double number = occupied(leaf);
    if (std::abs(number - wanted) < nearest) {
      nearest = std::abs(number - wanted);
      best = leaf;
    }
    if (number > wanted) {
      fine = leaf;
      many = number;
    }
    else {
      coarse = leaf;
      few = std::min(number, wanted * (1 - 1e-6));
    }
  }
  return best;
}

} // namespace linelet::clustering
