// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "start_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "vertex_hash.h"

namespace linelet {

namespace {

Indices
allOf(const Points& points)
{
  Indices all(points.size());
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

} // namespace

StartPoints::StartPoints(const Points& points,
                         const std::vector<MultiScaleShape>& shapes,
                         unsigned min_neighbors,
                         double neighbor_exponent)
    : StartPoints(points, shapes, min_neighbors, neighbor_exponent, allOf(points))
{
}

StartPoints::StartPoints(const Points& points,
                         const std::vector<MultiScaleShape>& shapes,
                         unsigned min_neighbors,
                         double neighbor_exponent,
                         const Indices& among)
    : points_(points)
{
  std::vector<double> scores(points.size());
  const auto collect = [&](unsigned least) {
    for (const Index i : among) {
      const MultiScaleShape& shape = shapes[i];
      const double base = double(shape.linearity_max) * double(shape.linearity_sum);
      if (shape.first_neighbors < least || !std::isfinite(shape.optimal_radius) ||
          !(base > 0))
        continue;
      scores[i] =
          std::pow(shape.first_neighbors, neighbor_exponent) * std::pow(base, 4);
      candidates_.push_back(i);
    }
  };
  collect(min_neighbors);
  if (candidates_.empty())
    collect(std::min(min_neighbors, 2u));
  std::sort(candidates_.begin(), candidates_.end(), [&](Index a, Index b) {
    return scores[a] != scores[b] ? scores[a] > scores[b] : a < b;
  });
  for (const Index i : candidates_)
    score_.push_back(scores[i]);
  squared_.assign(candidates_.size(), 1);
}

void
StartPoints::take(Index point)
{
  for (std::size_t c = 0; c < candidates_.size(); ++c) {
    const double squared = (points_[candidates_[c]] - points_[point]).squaredNorm();
    squared_[c] = any_ ? std::min(squared_[c], squared) : squared;
  }
  any_ = true;
}

Index
StartPoints::next(double least)
{
  std::size_t best = candidates_.size();
  double best_score = least;
  for (std::size_t c = 0; c < candidates_.size(); ++c) {
    const double score = std::sqrt(squared_[c]) * score_[c];
    if (score > best_score) {
      best = c;
      best_score = score;
    }
  }
  if (best == candidates_.size())
    return none;
  take(candidates_[best]);
  last_score_ = best_score;
  return candidates_[best];
}

Indices
StartPoints::spread(std::size_t count,
                    double spacing,
                    const std::function<bool(Index)>& wanted)
{
  Indices chosen;
  VertexHash taken(spacing);
  for (const Index i : candidates_) {
    if (chosen.size() == count)
      break;
    if (!wanted(i))
      continue;
    bool free = true;
    taken.forEachNear(points_[i], spacing, [&](Index other) {
      free = free && (points_[other] - points_[i]).squaredNorm() > spacing * spacing;
    });
    if (!free)
      continue;
    taken.insert(i, points_[i]);
    chosen.push_back(i);
  }
  return chosen;
}

} // namespace linelet
