// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief The shift that readers choose along an axis for coordinates from \a low to \a
 * high: a whole number near them; 0 if they are near the origin, or if there are none.
 */
double
wholeShift(double low, double high);

} // namespace io
} // namespace linelet
