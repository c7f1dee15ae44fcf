// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/io/cloud.h>

namespace linelet::io {

/** \brief The number format in which the coordinates of a cloud were most likely
 * stored. */
struct CoordinateForm {
  bool floats = true; ///< every world coordinate is a float
  int decimals = -1;  ///< of all world coordinates, -1: more than 9

  /** \brief Whether a float is close enough to represent the coordinate. */
  bool fits_float = true;
};

CoordinateForm
formOf(const Cloud& cloud);

/** \brief Appends a world coordinate in \a form. */
void
appendCoordinate(std::string& text, double value, const CoordinateForm& form);

} // namespace linelet::io
