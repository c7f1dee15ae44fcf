// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>

namespace linelet {

/** \brief What the fit needs to know about a cloud besides its points. */
struct CloudFrame {
  double scale_unit = 0; ///< D, the median distance to the sixth neighbor
  double diagonal = 0;   ///< of the bounding box
  double volume = 0;     ///< that outliers fill (an area if the cloud is flat)
  int dimensions = 3;    ///< 2 if the points lie in a plane
};

/** \brief Measures \a points (finite, at least one) whose scale unit is \a scale_unit.
 */
CloudFrame
frameOf(const Points& points, double scale_unit);

} // namespace linelet
