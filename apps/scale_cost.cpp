// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scale_cost.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace linelet::apps {

namespace {

constexpr double long_work = 3; // seconds
constexpr double trial = 0.1;   // seconds long enough to be measured

/** \brief Queries in a few clusters, since engines are faster on nearby queries. */
Indices
clusters(const Points& queries, const Indices& finite, std::size_t size)
{
  constexpr std::size_t centers = 3;
  size = std::min(size, finite.size());
  Indices sample;
  for (std::size_t c = 0; c < centers; ++c) {
    const Point center = queries[finite[finite.size() * (2 * c + 1) / (2 * centers)]];
    const auto nearer = [&](Index a, Index b) {
      return (queries[a] - center).squaredNorm() < (queries[b] - center).squaredNorm();
    };
    Indices sorted = finite;
    const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(size);
    std::nth_element(sorted.begin(), end - 1, sorted.end(), nearer);
    sample.insert(sample.end(), sorted.begin(), end);
  }
  return sample;
}

/** \brief The noise measures are defined for shapes about the query points. */
MultiScaleSettings
aboutPoints(MultiScaleSettings settings)
{
  settings.centroid = Centroid::QueryPoint;
  return settings;
}

} // namespace

ScaleCost
measuredCost(const Points& queries,
             std::size_t most,
             const std::function<double(const Indices&)>& work)
{
  using Clock = std::chrono::steady_clock;
  ScaleCost cost;
  Indices finite;
  for (std::size_t i = 0; i < queries.size(); ++i)
    if (queries[i].allFinite())
      finite.push_back(static_cast<Index>(i));
  if (finite.empty())
    return cost;
  double preparation = 0; // independent of the number of queries
  for (std::size_t size = 1; size <= most; size *= size == 1 ? 8 : 20) {
    const Indices sample = clusters(queries, finite, size);
    const Clock::time_point begin = Clock::now();
    const double neighbors = work(sample);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    if (size == 1)
      preparation = seconds;
    const auto count = static_cast<double>(sample.size());
    const double each = std::max(0.0, seconds - preparation) / count;
    cost.neighbors = neighbors / count;
    cost.seconds = preparation + each * static_cast<double>(finite.size());
    if (size > 1 && seconds - preparation > trial)
      break;
  }
  return cost;
}

void
announce(const ScaleCost& cost,
         std::size_t queries,
         const std::string& size,
         const char* option,
         const Frame& frame)
{
  if (cost.seconds > long_work)
    std::fprintf(stderr,
                 "%s: %.0f neighbors per point (%s); about %.0f s for %zu points, "
                 "less with a smaller %s\n",
                 frame.name().c_str(),
                 cost.neighbors,
                 size.c_str(),
                 cost.seconds,
                 queries,
                 option);
}

void
announceMultiScale(const Points& points,
                   const Points& queries,
                   const MultiScaleSettings& settings,
                   Frame& frame)
{
  const auto costOf = [&](const MultiScaleSettings& s) {
    // The grid shares its lists among the queries of a block; medians are always slow.
    const bool median =
        s.centroid == Centroid::Median || s.centroid == Centroid::WeightedMedian;
    const std::size_t most = s.engine == ScaleEngine::Grid && !median ? 3200 : 160;
    return measuredCost(queries, most, [&](const Indices& chosen) {
      Points some;
      for (const Index i : chosen)
        some.push_back(queries[i]);
      double neighbors = 0;
      const auto count = [&](std::size_t, const ShapeGraph& graph) {
        neighbors += graph.back().neighbors;
      };
      multiScaleShapes(points, some, s, count, &frame.monitor);
      return neighbors;
    });
  };
  ScaleCost cost = costOf(settings);
  if (settings.centroid != Centroid::QueryPoint)
    cost.seconds += costOf(aboutPoints(settings)).seconds;
  char size[64];
  std::snprintf(size, sizeof size, "largest radius %.4g", settings.radii.back());
  announce(cost, queries.size(), size, "--max-radius", frame);
}

} // namespace linelet::apps
