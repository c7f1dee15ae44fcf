// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <string>
#include <vector>

#include <linelet/curves/curve_network.h>
#include <linelet/screen/screen_normals.h>
#include <linelet/screen/tensor_splats.h>
#include <linelet/support/points.h>

#include "canvas.h"

namespace linelet::apps {

/** \brief What colors the points of a picture. */
enum class PixelColor {
  OfPoints, ///< their own colors
  Normal,   ///< the normal of what a pixel sees, relative to the eye
  Shaded    ///< light on it
};

/** \brief A cloud as it is drawn. */
struct CloudView {
  Points points;             ///< non-finite points are left out
  std::vector<Color> colors; ///< one per point
  Points point_normals;      ///< light on them replaces colors; empty: none
  PixelColor pixels = PixelColor::OfPoints;
  ScreenNormalSettings normals; ///< for the other two
  CurveNetwork curves;          ///< drawn over the points
  std::string title;
  std::string unit;       ///< of length, for the scale bar; may be empty
  double azimuth = 210;   ///< direction of the eye, degrees clockwise from north (y)
  double elevation = 35;  ///< degrees above the horizon, 90: from above
  double point_size = 0;  ///< diameter in pixels; 0: by density
  double curve_width = 3; ///< pixels
};

/** \brief Parallel projection with depth-shaded points, the curves on top, and a scale
 * bar that holds for horizontal lengths across the view. The lowest \a bottom pixels
 * stay free for a legend. */
Canvas
drawCloud(const CloudView& view, int width, int height, double bottom);

/** \brief Draws something as seen by a camera. */
using DrawImage = std::function<GlyphImage(const Camera& camera)>;

/** \brief The same, with whatever \a draw draws in place of the points, which only
 * determine the view. */
Canvas
drawImage(
    const CloudView& view, const DrawImage& draw, int width, int height, double bottom);

} // namespace linelet::apps
