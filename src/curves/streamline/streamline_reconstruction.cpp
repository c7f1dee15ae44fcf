// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/streamline_reconstruction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <linelet/search/scale_unit.h>
#include <linelet/search/uniform_grid.h>

#include "direction_field.h"
#include "growth.h"
#include "joining.h"
#include "line_lets.h"
#include "start_points.h"

namespace linelet {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr unsigned first_starts = 8;  // where their number is left open
constexpr unsigned cover_rounds = 20; // of further ones
constexpr double most_pairs = 3e8;    // point and neighbor, in the features

/** \brief The finite points of \a points; without repetition where more than half of
 * them lie upon others, so that they have a scale. */
Points
usable(const Points& points, double& scale_unit, const StreamlineSettings& settings)
{
  Points finite;
  for (const Point& p : points)
    if (p.allFinite())
      finite.push_back(p);
  const auto measure = [&] {
    return settings.shape.scale_unit > 0 ? settings.shape.scale_unit
                                         : scaleUnit(finite,
                                                     settings.shape.scale_unit_sample,
                                                     settings.shape.scale_unit_seed,
                                                     settings.threads);
  };
  scale_unit = measure();
  if (scale_unit == 0) {
    const auto before = [](const Point& a, const Point& b) {
      return std::lexicographical_compare(
          a.data(), a.data() + 3, b.data(), b.data() + 3);
    };
    std::sort(finite.begin(), finite.end(), before);
    finite.erase(std::unique(finite.begin(), finite.end()), finite.end());
    scale_unit = measure();
  }
  return finite;
}

/** \brief Every point moved to the mean of those within \a radius. */
Points
smoothed(const Points& points, double radius)
{
  const UniformGrid grid(points, radius);
  Points result;
  for (const Point& p : points) {
    Point sum = Point::Zero();
    std::size_t count = 0;
    grid.forEachWithin(p, radius, [&](Index i, double) {
      sum += points[i] - p;
      ++count;
    });
    result.push_back(p + sum / static_cast<double>(count));
  }
  return result;
}

/** \brief The radius up to \a wanted, not below a few \a scale_unit, whose
 * neighborhoods are small enough that the features of all points stay affordable. */
double
affordableRadius(const Points& points,
                 const UniformGrid& grid,
                 double wanted,
                 double scale_unit)
{
  constexpr std::size_t most_samples = 64;
  const std::size_t stride = points.size() / most_samples + 1;
  for (;; wanted /= 1.5) {
    double pairs = 0;
    for (std::size_t i = 0; i < points.size() && pairs <= most_pairs; i += stride)
      pairs += static_cast<double>(grid.countWithin(points[i], wanted)) *
               static_cast<double>(stride);
    if (pairs <= most_pairs || wanted <= 4 * scale_unit)
      return wanted;
  }
}

GrowthLimits
limitsOf(const Points& points, double scale_unit, const StreamlineSettings& settings)
{
  GrowthLimits limits;
  limits.step = settings.step * scale_unit;
  limits.distance_cutoff =
      settings.distance_cutoff > 0 ? settings.distance_cutoff : 2 * scale_unit;
  limits.merge_distance = settings.merge_distance * limits.step;
  limits.branch_cosine = std::cos(settings.branch_angle * pi / 180);
  limits.low = limits.high = points.front();
  for (const Point& p : points) {
    limits.low = limits.low.cwiseMin(p);
    limits.high = limits.high.cwiseMax(p);
  }
  const double diagonal = (limits.high - limits.low).norm();
  // A flat cloud has no room for rounding in its bounds.
  limits.low.array() -= limits.step;
  limits.high.array() += limits.step;
  const double points_count = static_cast<double>(points.size());
  const double most = std::min(4 * diagonal / limits.step + 16, 4 * points_count + 64);
  limits.max_iterations = settings.max_iterations > 0
                              ? settings.max_iterations
                              : static_cast<unsigned>(std::min(most, 4e9));
  limits.total_steps = 4 * points.size() + 4096;
  return limits;
}

/** \brief Marks the points that have a vertex within \a distance. */
void
coverPoints(std::vector<bool>& covered,
            const Points& points,
            const LineLets& lets,
            double distance)
{
  Points vertices;
  for (const LineLetVertex& vertex : lets.vertices)
    vertices.push_back(vertex.position);
  const UniformGrid grid(vertices, distance / 2);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!covered[i])
      covered[i] = grid.nearest(points[i], distance) != UniformGrid::none;
}

} // namespace

CurveNetwork
reconstructPublished(const Points& input,
                     const StreamlineSettings& settings,
                     ProgressMonitor* monitor)
{
  validate(settings);
  double scale_unit = 0;
  Points points = usable(input, scale_unit, settings);
  if (!(scale_unit > 0))
    return {};
  if (settings.prefilter_radius > 0)
    points = smoothed(points, settings.prefilter_radius);

  const UniformGrid grid(points, 2.5 * scale_unit);
  MultiScaleSettings shape_settings = settings.shape;
  shape_settings.scale_unit = scale_unit;
  shape_settings.threads = settings.threads;
  if (shape_settings.max_radius == 0 && shape_settings.radii.empty())
    shape_settings.max_radius = affordableRadius(
        points, grid, std::max(settings.largest_radius, 1.0) * scale_unit, scale_unit);
  const MultiScaleShapes shapes =
      multiScaleShapes(points, points, shape_settings, {}, monitor);

  if (monitor != nullptr)
    monitor->begin("curves", 0);
  const DirectionField field(points, shapes, grid, settings);
  StartPoints starts(points,
                     shapes.shapes,
                     settings.min_start_neighbors,
                     settings.start_neighbor_exponent);
  GrowthLimits limits = limitsOf(points, scale_unit, settings);
  LineLets lets(std::max(limits.merge_distance, limits.step));
  const auto begin = [&](Index i) { lets.start(points[i], field.eigenvector(i)); };

  const unsigned wanted =
      settings.start_points > 0 ? settings.start_points : first_starts;
  for (unsigned i = 0; i < wanted; ++i) {
    const Index start = starts.next();
    if (start == StartPoints::none)
      break;
    begin(start);
  }
  grow(lets, field, grid, limits, settings, monitor);

  const double cover = settings.cover_distance * scale_unit;
  std::vector<bool> covered(points.size(), false);
  for (unsigned round = 0; settings.start_points == 0 && round < cover_rounds;
       ++round) {
    coverPoints(covered, points, lets, cover);
    const auto uncovered = [&](Index i) { return !covered[i]; };
    const Indices more =
        starts.spread(std::numeric_limits<std::size_t>::max(), 4 * cover, uncovered);
    if (more.empty() || limits.total_steps == 0)
      break;
    for (const Index i : more)
      begin(i);
    grow(lets, field, grid, limits, settings, monitor);
  }
  pruneOpenEnds(lets, grid, settings.prune_distance * limits.step);
  return join(lets, settings.stump_length * limits.step);
}

} // namespace linelet
