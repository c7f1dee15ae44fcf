// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <linelet/features/linearity_graph.h>
#include <linelet/features/multi_scale.h>
#include <linelet/features/point_types.h>
#include <linelet/features/tensor_settings.h>
#include <linelet/search/uniform_grid.h>

#include "scene.h"

namespace linelet::view {

/** \brief The graphs of all points, from a run over them. */
struct GraphStore {
  std::vector<double> radii;
  std::vector<ScaleShape> shapes; ///< point by point, radius by radius

  ShapeGraph
  of(Index point) const
  {
    const auto first =
        shapes.begin() + static_cast<std::ptrdiff_t>(point * radii.size());
    return {first, first + static_cast<std::ptrdiff_t>(radii.size())};
  }
};

/** \brief The graphs of one point, and what is derived from them. */
struct PointGraphs {
  std::vector<double> radii;
  /// From a store: those of that run. Otherwise those of `multiscale --graphs` with
  /// engine sweep: to the last digit up to 4 million points, to rounding beyond.
  ShapeGraph graph;
  bool stored = false;                      ///< whether they are from a store
  LinearityGraph reading;                   ///< maxima and their scores
  std::size_t scale = LinearityGraph::none; ///< the optimal one
  /// Over the points within the optimal radius (at most 64 of them): mean and standard
  /// deviation of CL, CP, CS at every radius; NaN where none of them is defined.
  struct Spread {
    double mean[3], deviation[3];
  };
  std::vector<Spread> spread;

  double
  ownRadius() const
  {
    return scale == LinearityGraph::none ? 0 : radii[scale];
  }
};

/** \brief The graphs of \a point of \a scene at \a radii, in double, or from a store.
 * \param[in] store graphs of all points at these radii, or null
 * \throws Canceled */
PointGraphs
graphsAt(const Scene& scene,
         Index point,
         const std::vector<double>& radii,
         const MultiScaleSettings& settings,
         const GraphStore* store = nullptr,
         ProgressMonitor* monitor = nullptr);

/** \brief A multi-scale image and its axes: one column per position. */
struct ScaleImage {
  std::vector<double> along; ///< arc length of every column
  std::vector<double> radii; ///< of every row
  Points places;
  std::vector<ShapeGraph> columns;
  std::vector<MultiScaleShape> shapes; ///< one per column
};

/** \brief The multi-scale image along \a line, at \a columns evenly spaced positions.
 * \throws Canceled */
ScaleImage
scaleImageAlong(const Scene& scene,
                const Points& line,
                std::size_t columns,
                const std::vector<double>& radii,
                const MultiScaleSettings& settings,
                ProgressMonitor* monitor = nullptr);

/** \brief The same for the points within \a radius of \a point, sorted along \a axis;
 * at most \a columns of them. */
ScaleImage
scaleImageAround(const Scene& scene,
                 Index point,
                 double radius,
                 const Point& axis,
                 std::size_t columns,
                 const std::vector<double>& radii,
                 const MultiScaleSettings& settings,
                 ProgressMonitor* monitor = nullptr);

/** \brief The tensor of \a point at \a radius, as `tensor` computes it. */
PointDistributionTensor
tensorAt(const Scene& scene, Index point, double radius, TensorSettings settings);

/** \brief A histogram of the distances of neighbors from \a point: counts for equal
 * steps of distance / \a radius from 0 to 1, without the point itself. */
std::vector<std::size_t>
distanceHistogram(const Scene& scene, Index point, double radius, std::size_t bins);

} // namespace linelet::view
