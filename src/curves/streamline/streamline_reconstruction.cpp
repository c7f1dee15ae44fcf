// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/streamline_reconstruction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <linelet/features/centroid_shift.h>
#include <linelet/search/scale_unit.h>
#include <linelet/search/subset_search.h>
#include <linelet/search/uniform_grid.h>

#include "cloud_neighbors.h"
#include "direction_field.h"
#include "growth.h"
#include "joining.h"
#include "line_lets.h"
#include "pruning.h"
#include "start_points.h"

namespace linelet {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr unsigned first_starts = 8;  // where their number is left open
constexpr unsigned cover_rounds = 20; // of further ones
constexpr double most_pairs = 3e8;    // point and neighbor, in the features

Indices
finiteOnes(const Points& points)
{
  Indices finite;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      finite.push_back(static_cast<Index>(i));
  return finite;
}

/** \brief \a chosen without those that lie upon others, by place. */
Indices
withoutRepetition(const Points& points, Indices chosen)
{
  std::sort(chosen.begin(), chosen.end(), [&](Index i, Index j) {
    const Point &a = points[i], &b = points[j];
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  });
  const auto same = [&](Index i, Index j) { return points[i] == points[j]; };
  chosen.erase(std::unique(chosen.begin(), chosen.end(), same), chosen.end());
  return chosen;
}

/** \brief The points that line-lets follow, how they are found, and their scale. */
class StreamlinePoints {
public:
  /** \brief The finite points of \a all; without repetition where more than half of
   * them lie upon others, so that they have a scale.
   * \param[in] search over \a all, or null */
  StreamlinePoints(const Points& all,
                   const NeighborSearch* search,
                   const StreamlineSettings& settings)
      : search_(search)
  {
    choose(all, finiteOnes(all));
    measure(settings);
    if (scale_unit == 0) {
      subset_.reset();
      search_ = search;
      choose(all, withoutRepetition(all, finiteOnes(all)));
      measure(settings);
    }
    if (!(scale_unit > 0))
      return;
    if (settings.prefilter_radius > 0) {
      CentroidShiftSettings shift;
      shift.radius = settings.prefilter_radius;
      shift.threads = settings.threads;
      points = search_ != nullptr ? shiftToCentroids(*search_, points, shift)
                                  : shiftToCentroids(points, shift);
      search_ = nullptr; // it knows nothing of the moved points
    }
    neighbors.emplace(points, 2.5 * scale_unit, search_);
  }
  StreamlinePoints(const StreamlinePoints&) = delete;
  StreamlinePoints&
  operator=(const StreamlinePoints&) = delete;

  Points points;
  double scale_unit = 0; ///< D; where it is not positive, there are no neighbors
  std::optional<CloudNeighbors> neighbors;

private:
  void
  choose(const Points& all, const Indices& chosen)
  {
    points.clear();
    for (const Index i : chosen)
      points.push_back(all[i]);
    if (search_ == nullptr || chosen.size() == all.size())
      return;
    subset_.emplace(*search_, all, chosen);
    search_ = &*subset_;
  }

  void
  measure(const StreamlineSettings& settings)
  {
    const MultiScaleSettings& shape = settings.shape;
    if (shape.scale_unit > 0)
      scale_unit = shape.scale_unit;
    else if (search_ != nullptr)
      scale_unit = scaleUnit(*search_,
                             points,
                             shape.scale_unit_sample,
                             shape.scale_unit_seed,
                             settings.threads);
    else
      scale_unit = scaleUnit(
          points, shape.scale_unit_sample, shape.scale_unit_seed, settings.threads);
  }

  const NeighborSearch* search_;
  std::optional<SubsetSearch> subset_;
};

/** \brief The radius up to \a wanted, not below a few \a scale_unit, whose
 * neighborhoods are small enough that the features of all points stay affordable. */
double
affordableRadius(const Points& points,
                 const CloudNeighbors& neighbors,
                 double wanted,
                 double scale_unit)
{
  constexpr std::size_t most_samples = 64;
  const std::size_t stride = points.size() / most_samples + 1;
  for (;; wanted /= 1.5) {
    double pairs = 0;
    for (std::size_t i = 0; i < points.size() && pairs <= most_pairs; i += stride)
      pairs += static_cast<double>(neighbors.countWithin(points[i], wanted)) *
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

CurveNetwork
reconstruct(const Points& input,
            const NeighborSearch* search,
            const StreamlineSettings& settings,
            ProgressMonitor* monitor)
{
  validate(settings);
  const StreamlinePoints cloud(input, search, settings);
  const double scale_unit = cloud.scale_unit;
  if (!(scale_unit > 0))
    return {};
  const Points& points = cloud.points;
  const CloudNeighbors& neighbors = *cloud.neighbors;

  MultiScaleSettings shape_settings = settings.shape;
  shape_settings.scale_unit = scale_unit;
  shape_settings.threads = settings.threads;
  if (shape_settings.max_radius == 0 && shape_settings.radii.empty())
    shape_settings.max_radius =
        affordableRadius(points,
                         neighbors,
                         std::max(settings.largest_radius, 1.0) * scale_unit,
                         scale_unit);
  const MultiScaleShapes shapes =
      neighbors.search() != nullptr
          ? multiScaleShapes(
                *neighbors.search(), points, points, shape_settings, {}, monitor)
          : multiScaleShapes(points, points, shape_settings, {}, monitor);

  if (monitor != nullptr)
    monitor->begin("curves", 0);
  const DirectionField field(points, shapes, neighbors, settings);
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
  grow(lets, field, neighbors, limits, settings, monitor);

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
    grow(lets, field, neighbors, limits, settings, monitor);
  }
  pruneOpenEnds(lets, neighbors, settings.prune_distance * limits.step);
  return join(lets, settings.stump_length * limits.step);
}

} // namespace

CurveNetwork
reconstructPublished(const Points& points,
                     const StreamlineSettings& settings,
                     ProgressMonitor* monitor)
{
  return reconstruct(points, nullptr, settings, monitor);
}

CurveNetwork
reconstructPublished(const NeighborSearch& search,
                     const Points& points,
                     const StreamlineSettings& settings,
                     ProgressMonitor* monitor)
{
  return reconstruct(points, &search, settings, monitor);
}

} // namespace linelet
