// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>

namespace linelet {

/** \brief A share of the points of a component. */
struct ThinnedComponent {
  Points points;
  double share = 1; ///< of all
};

/** \brief A subset of \a points with about \a size times the spacing, for curves that
 * are thick compared with the spacing. */
ThinnedComponent
thinnedComponent(const Points& points, double size);

} // namespace linelet
