// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Summary of the shapes of a point's neighborhood over many scales.
 *
 * Undefined values are NaN (scale: -1): all of them if no scale has two neighbors
 * besides the point; the shape at the optimal scale, its radius, blend and direction if
 * no scale has enough neighbors to be chosen. */
struct MultiScaleShape {
  static constexpr float nan = std::numeric_limits<float>::quiet_NaN();

  float linearity = nan;      ///< CL at the optimal scale, [0, 1]
  float planarity = nan;      ///< CP at the optimal scale, [0, 1]
  float sphericity = nan;     ///< CS at the optimal scale, [0, 1]
  float optimal_radius = nan; ///< radius of the optimal scale, unit of the input
  float blend = nan; ///< mu, weight of the eigenvector in a direction, [0.05, 0.95]
  float linearity_sum = nan;  ///< A, area under the linearity graph
  float linearity_max = nan;  ///< CL_max, the largest linearity of all scales
  float min_sphericity = nan; ///< the smallest sphericity of all scales
  float major_x = nan;        ///< e3 at the optimal scale, a unit vector whose
  float major_y = nan;        ///< component of largest magnitude is positive
  float major_z = nan;
  /// Points in the neighborhood of the optimal scale, the point itself included; 0
  /// where there is none.
  std::uint32_t neighbors = 0;
  /// N1: neighbors besides the point at the smallest scale that has any; 0 if there is
  /// none.
  std::uint32_t first_neighbors = 0;
  std::int32_t scale = -1; ///< the optimal scale, counted from 0
};

/** \brief The shape of one neighborhood: one point of the graphs CL, CP, CS. NaN if the
 * scale is undefined: fewer than 2 neighbors away from the point, or all weights 0. */
struct ScaleShape {
  static constexpr float nan = std::numeric_limits<float>::quiet_NaN();

  float linearity = nan;  ///< CL, [0, 1]
  float planarity = nan;  ///< CP, [0, 1]
  float sphericity = nan; ///< CS, [0, 1]
  float major_x = nan;    ///< e3, a unit vector
  float major_y = nan;
  float major_z = nan;
  std::uint32_t neighbors = 0; ///< the point itself included
};

/** \brief The graphs of one point: a shape at every radius, small to large. */
using ShapeGraph = std::vector<ScaleShape>;

/** \brief The multi-scale shape feature of a set of points. */
struct MultiScaleShapes {
  double scale_unit = 0;     ///< D; NaN where the points have none (see scaleUnit)
  std::vector<double> radii; ///< of the scales, ascending
  std::vector<MultiScaleShape> shapes; ///< one per query
};

/** \brief Receives the graphs of every query, in the order of the queries and never
 * from two threads at once. The graph is valid during the call. */
using ShapeGraphSink = std::function<void(std::size_t query, const ShapeGraph& graph)>;

} // namespace linelet
