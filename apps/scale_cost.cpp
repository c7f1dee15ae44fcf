// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scale_cost.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iterator>

namespace linelet::apps {

namespace {

/** \brief Points in some neighborhoods: engines gain from queries that lie together.
 */
Points
clusters(const Points& points, std::size_t centers, std::size_t size)
{
  size = std::min(size, points.size());
  const auto end = static_cast<std::ptrdiff_t>(size);
  Points sample;
  for (std::size_t c = 0; c < centers; ++c) {
    const Point center = points[points.size() * (2 * c + 1) / (2 * centers)];
    const auto nearer = [&](const Point& a, const Point& b) {
      return (a - center).squaredNorm() < (b - center).squaredNorm();
    };
    Points sorted = points;
    std::nth_element(sorted.begin(), sorted.begin() + end - 1, sorted.end(), nearer);
    sample.insert(sample.end(), sorted.begin(), sorted.begin() + end);
  }
  return sample;
}

/** \brief Wall time of the feature at \a queries, seconds. */
double
timeOf(const Points& points,
       const Points& queries,
       const MultiScaleSettings& settings,
       const ShapeGraphSink& sink = {})
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  multiScaleShapes(points, queries, settings, sink);
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

} // namespace

ScaleCost
estimateCost(const Points& points, const MultiScaleSettings& settings)
{
  constexpr std::size_t centers = 3;
  // The grid shares its lists among the queries of a block; medians are slow by
  // themselves.
  const bool median = settings.centroid == Centroid::Median ||
                      settings.centroid == Centroid::WeightedMedian;
  const std::size_t size = settings.engine == ScaleEngine::Grid && !median ? 3000 : 100;
  Points finite;
  std::copy_if(points.begin(), points.end(), std::back_inserter(finite), [](auto& p) {
    return p.allFinite();
  });
  if (finite.empty())
    return {};
  const Points few = clusters(finite, centers, 1),
               many = clusters(finite, centers, size);
  ScaleCost cost;
  // Preparation takes the same for few and many.
  const double preparation = timeOf(finite, few, settings);
  const double of_many =
      timeOf(finite, many, settings, [&](std::size_t, const ShapeGraph& graph) {
        cost.neighbors += graph.back().neighbors;
      });
  const auto count = static_cast<double>(many.size());
  cost.neighbors /= count;
  cost.seconds = preparation + std::max(0.0, of_many - preparation) / count *
                                   static_cast<double>(finite.size());
  return cost;
}

} // namespace linelet::apps
