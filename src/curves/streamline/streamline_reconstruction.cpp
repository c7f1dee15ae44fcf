// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/streamline_reconstruction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <linelet/features/centroid_shift.h>
#include <linelet/search/scale_unit.h>
#include <linelet/search/subset_search.h>
#include <linelet/search/uniform_grid.h>
#include <search/random_sample.h>

#include "cloud_neighbors.h"
#include "direction_field.h"
#include "growth.h"
#include "joining.h"
#include "line_lets.h"
#include "pruning.h"
#include "start_points.h"
#include "tensor_shapes.h"

namespace linelet {

namespace {

constexpr double pi = 3.14159265358979323846;
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
    if (settings.prefilter.radius > 0) {
      CentroidShiftSettings shift = settings.prefilter;
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

  /** \brief The place among \ref points of the one that has \a index among all.
   * \throws std::invalid_argument where it is none of them */
  Index
  placeOf(Index index, std::size_t all) const
  {
    if (index >= all)
      throw std::invalid_argument("start " + std::to_string(index) +
                                  " is not one of the " + std::to_string(all) +
                                  " points, which count from 0");
    const auto found = std::find(chosen_.begin(), chosen_.end(), index);
    if (found == chosen_.end())
      throw std::invalid_argument(
          "start " + std::to_string(index) +
          " is a point without coordinates, left out, or a copy of another");
    return static_cast<Index>(found - chosen_.begin());
  }

  /** \brief The places among all points of \ref points. */
  const Indices&
  chosen() const
  {
    return chosen_;
  }

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
    chosen_ = chosen;
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
  Indices chosen_; // of all points
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

/** \brief The features of the points; with those of another centroid, where start
 * points are scored by it. */
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
    shape.stop_change = 0; // it has had its say
    shape.centroid = settings.start_centroid;
    for_starts_ = measure();
  }

  MultiScaleShapes features;
  std::vector<SymmetricTensor> tensors; ///< of the points, where they are given

  /** \brief Those by which start points are scored. */
  const std::vector<MultiScaleShape>&
  forStarts() const
  {
    return for_starts_.shapes.empty() ? features.shapes : for_starts_.shapes;
  }

private:
  MultiScaleShapes for_starts_;
};

/** \brief Begins line-lets where the user says, or at the points of the best score. */
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

/** \brief Begins line-lets far from all others and grows them, until the points are
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
