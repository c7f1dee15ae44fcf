// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief A flat convex face. */
struct Face {
  Index part = 0; ///< index of what it belongs to, such as a representative
  Points corners; ///< counterclockwise, seen from where the normal points
  Point normal = Point::Zero();
};

} // namespace linelet
