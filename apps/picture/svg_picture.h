// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cloud_view.h"

namespace linelet::apps {

/** \brief Tensors to draw as ellipses: projections of ellipsoids whose axes are the
 * square roots of the eigenvalues. */
struct SvgTensors {
  std::vector<Eigen::Matrix3d> tensors; ///< one per point of the view; NaN: none
  std::vector<Color> colors;            ///< one per point
  double size = 0; ///< length of a unit root, in the unit of the points
};

/** \brief A vector picture of lines: from above (elevation 90) in parallel projection,
 * otherwise in perspective, where curves are outlined bands, wider the nearer they are.
 *
 * Points are drawn if there are at most 20,000; curves far to near.
 * \return the text of an SVG file */
std::string
svgOfCloud(const CloudView& view,
           const SvgTensors& tensors,
           ShapeColors colors,
           int width,
           int height);

} // namespace linelet::apps
