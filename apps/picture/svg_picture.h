// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cloud_view.h"

namespace linelet::apps {

/** \brief Tensors to be drawn as ellipses, the shadows of ellipsoids whose axes are the
 * roots of their eigenvalues. */
struct SvgTensors {
  std::vector<Eigen::Matrix3d> tensors; ///< one per point of the view; NaN: none
  std::vector<Color> colors;            ///< one per point
  double size = 0; ///< length of a root of 1, in the unit of the points
};

/** \brief A picture of lines that stay lines: from above (elevation 90) in parallel
 * projection, else in perspective, where curves are outlined bands, the wider the
 * nearer they are.
 *
 * Points are drawn where there are at most 20,000 of them; curves far to near.
 * \return the text of an SVG file */
std::string
svgOfCloud(const CloudView& view,
           const SvgTensors& tensors,
           ShapeColors colors,
           int width,
           int height);

} // namespace linelet::apps
