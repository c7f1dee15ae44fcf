// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/features/linearity_graph.h>
#include <linelet/features/multi_scale_types.h>
#include <linelet/support/points.h>

#include "canvas.h"

namespace linelet::apps {

/** \brief The shapes of neighborhoods along a line, at many radii. */
struct ShapeProfile {
  std::string title;
  std::string position_label;     ///< quantity along the picture
  std::vector<double> positions;  ///< of the columns, rising, evenly spaced
  std::vector<double> radii;      ///< of the rows, rising
  std::vector<ShapeGraph> graphs; ///< one per column
  std::vector<double> chosen;     ///< optimal radius of each column, NaN: none
  std::vector<double> sums;       ///< linearity sum A of each column, NaN: none
};

/** \brief Multi-scale feature image: one column per position, one row per radius (small
 * at the bottom), colored by shape; the optimal radius as a dotted line, the
 * linearity sum as a line from 0 at the bottom to its largest at the top. White where
 * there is no shape. */
Canvas
drawShapeProfile(const ShapeProfile& profile,
                 ShapeColors colors,
                 int width,
                 int height);

/** \brief The graphs of one point. */
struct PointGraphs {
  std::string title;
  std::vector<double> radii; ///< of the scales
  ShapeGraph graph;          ///< at these
  std::vector<double> fine_radii;
  ShapeGraph fine_graph;          ///< at many radii, for the lines between the scales
  std::vector<ShapeGraph> around; ///< of its neighbors, at the many radii; may be empty
  LinearityGraph analysis;        ///< of the graph at the scales
};

/** \brief CL, CP and CS of a point over the radius, with the local extrema of the
 * linearity and the chosen radius marked; light lines one standard deviation above and
 * below the mean of its neighbors. */
Canvas
drawPointGraphs(const PointGraphs& graphs, ShapeColors colors, int width, int height);

} // namespace linelet::apps
