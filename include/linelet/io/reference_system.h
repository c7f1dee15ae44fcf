// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

struct Cloud;

/** \brief Name of the reference system that \a wkt describes; empty if it is unknown or
 * not understood. */
std::string
referenceName(const std::string& wkt);

/** \brief The units of coordinates. */
struct Units {
  double plan = 1;                   ///< meters per unit of x and y; NaN: not a length
  double height = 1;                 ///< meters per unit of z
  std::string plan_name = "metre";   ///< "degree", "US survey foot", ...
  std::string height_name = "metre"; ///< the same for z
  bool height_stated = true;         ///< else z is assumed to have the unit of x and y

  /** \brief Whether every unit is the meter. */
  bool
  areMeters() const
  {
    return plan == 1 && height == 1;
  }
};

/** \brief The units of the reference system \a wkt: those of its horizontal and of its
 * vertical part. Meters if it is empty or not understood. */
Units
unitsOf(const std::string& wkt);

/** \brief Why lengths in the plan of \a cloud are meaningless, as a clause to follow
 * the name of its file: its reference system is in degrees, or it has none and the
 * coordinates look like degrees. Empty if they are lengths, as far as is known. */
std::string
degreesIn(const Cloud& cloud);

} // namespace io
} // namespace linelet
