// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/streamline_reconstruction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <linelet/features/multi_scale.h>
#include <linelet/search/uniform_grid.h>

#include "cloud_neighbors.h"
#include "direction_field.h"
#include "growth.h"
#include "joining.h"
#include "line_lets.h"
#include "pruning.h"
#include "search/random_sample.h"
#include "start_points.h"
#include "streamline_points.h"
#include "tensor_shapes.h"

namespace linelet {

namespace {

constexpr unsigned cover_rounds = 20; // of additional line-lets
constexpr double most_pairs = 3e8;    // point and neighbor, in the features

/** \brief The largest radius up to \a wanted, but at least a few \a scale_unit, for
 * which computing the features of all points stays affordable. */
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
  limits.branch_cosine = std::cos(settings.branch_angle * M_PI / 180);
  limits.low = limits.high = points.front();
  for (const Point& p : points) {
    limits.low = limits.low.cwiseMin(p);
    limits.high = limits.high.cwiseMax(p);
  }
  const double diagonal = (limits.high - limits.low).norm();
  // The bounds of a flat cloud leave no room for rounding.
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

/** \brief Marks the points with a vertex within \a distance. */
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

/** \brief The features of the points, and those for another centroid if it scores the
 * start points. */
class StreamlineShapes {
public:
  StreamlineShapes(const StreamlinePoints& cloud,
                   const StreamlineSettings& settings,
                   ProgressMonitor* monitor)
  {
    if (!settings.tensors.empty()) {
      for (const Index i : cloud.chosen())
        tensors.push_back(settings.tensors[i]);
      features = shapesOfTensors(tensors, cloud.scale_unit, settings);
      return;
    }
    MultiScaleSettings shape = settings.shape;
    shape.scale_unit = cloud.scale_unit;
    shape.threads = settings.threads;
    if (shape.max_radius == 0 && shape.radii.empty()) {
      const double largest = settings.largest_radius > 0 ? settings.largest_radius
                                                         : published_largest_radius;
      shape.max_radius = affordableRadius(cloud.points,
                                          *cloud.neighbors,
                                          std::max(largest, 1.0) * cloud.scale_unit,
                                          cloud.scale_unit);
    }
    const auto measure = [&] {
      const NeighborSearch* search = cloud.neighbors->search();
      return search != nullptr
                 ? multiScaleShapes(
                       *search, cloud.points, cloud.points, shape, {}, monitor)
                 : multiScaleShapes(cloud.points, cloud.points, shape, {}, monitor);
    };
    features = measure();
    if (settings.start_centroid == shape.centroid || !settings.starts.empty())
      return;
    shape.radii = features.radii;
    shape.stop_change = 0; // already applied to the radii
    shape.centroid = settings.start_centroid;
    for_starts_ = measure();
  }

  MultiScaleShapes features;
  std::vector<SymmetricTensor> tensors; ///< of the points, where they are given

  /** \brief The features that score start points. */
  const std::vector<MultiScaleShape>&
  forStarts() const
  {
    return for_starts_.shapes.empty() ? features.shapes : for_starts_.shapes;
  }

private:
  MultiScaleShapes for_starts_;
};

/** \brief Starts line-lets where the user asked, or at the points with the best
 * scores. */
template <class Begin>
void
beginLineLets(const StreamlinePoints& cloud,
              std::size_t all_points,
              StartPoints& starts,
              const StreamlineSettings& settings,
              const Begin& begin)
{
  for (const Index start : settings.starts)
    begin(cloud.placeOf(start, all_points));
  if (!settings.starts.empty())
    return;
  const std::size_t most =
      settings.start_points > 0 ? settings.start_points : cloud.points.size();
  double least = 0;
  for (std::size_t i = 0; i < most; ++i) {
    const Index start = starts.next(least);
    if (start == StartPoints::none)
      break;
    begin(start);
    if (i == 1 && settings.start_points == 0)
      least = settings.start_threshold * starts.lastScore();
  }
}

/** \brief Starts line-lets far from all others and grows them, until the points are
 * covered. */
template <class Begin>
void
coverRemainder(LineLets& lets,
               const StreamlinePoints& cloud,
               const DirectionField& field,
               StartPoints& starts,
               GrowthLimits& limits,
               const StreamlineSettings& settings,
               ProgressMonitor* monitor,
               const Begin& begin)
{
  const double cover = settings.cover_distance * cloud.scale_unit;
  std::vector<bool> covered(cloud.points.size(), false);
  for (unsigned round = 0; round < cover_rounds && limits.total_steps > 0; ++round) {
    coverPoints(covered, cloud.points, lets, cover);
    const auto uncovered = [&](Index i) { return !covered[i]; };
    const Indices more =
        starts.spread(std::numeric_limits<std::size_t>::max(), 4 * cover, uncovered);
    if (more.empty())
      return;
    for (const Index i : more)
      begin(i);
    grow(lets, field, *cloud.neighbors, limits, settings, monitor);
  }
}

CurveNetwork
reconstruct(const Points& input,
            const NeighborSearch* search,
            const StreamlineSettings& settings,
            ProgressMonitor* monitor)
{
  validate(settings);
  if (!settings.tensors.empty() && settings.tensors.size() != input.size())
    throw std::invalid_argument(std::to_string(settings.tensors.size()) +
                                " tensors are given for " +
                                std::to_string(input.size()) + " points");
  const StreamlinePoints cloud(input, search, settings);
  if (!(cloud.scale_unit > 0))
    return {};
  const StreamlineShapes shapes(cloud, settings, monitor);
  if (monitor != nullptr)
    monitor->begin("curves", 0);
  const DirectionField field(
      cloud.points, shapes.features, *cloud.neighbors, settings, shapes.tensors);
  Indices among(cloud.points.size());
  std::iota(among.begin(), among.end(), Index{0});
  keepRandomSample(among, settings.start_candidates, settings.shape.scale_unit_seed);
  StartPoints starts(cloud.points,
                     shapes.forStarts(),
                     settings.min_start_neighbors,
                     settings.start_neighbor_exponent,
                     among);
  GrowthLimits limits = limitsOf(cloud.points, cloud.scale_unit, settings);
  LineLets lets(std::max(limits.merge_distance, limits.step));
  const auto begin = [&](Index i) {
    const Point e3 = field.eigenvector(i);
    if (settings.seed_direction.empty()) {
      lets.start(cloud.points[i], e3);
      return;
    }
    const Point seed(settings.seed_direction.data());
    const bool known = e3.allFinite();
    const Index line = lets.start(cloud.points[i],
                                  !known             ? Point(seed.normalized())
                                  : e3.dot(seed) < 0 ? Point(-e3)
                                                     : e3);
    lets.lines[line].ends[back_side].growing = false;
  };

  beginLineLets(cloud, input.size(), starts, settings, begin);
  grow(lets, field, *cloud.neighbors, limits, settings, monitor);
  if (settings.start_points == 0 && settings.starts.empty() &&
      settings.cover_distance > 0)
    coverRemainder(lets, cloud, field, starts, limits, settings, monitor, begin);
  pruneOpenEnds(lets, *cloud.neighbors, settings.prune_distance * limits.step);
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
