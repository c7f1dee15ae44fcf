// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

struct Cloud;

/** \brief Name of the reference system that \a wkt describes; empty where it is unknown
 * or cannot be understood. */
std::string
referenceName(const std::string& wkt);

/** \brief The units that coordinates count in. */
struct Units {
  double plan = 1;                   ///< meters in one of x and y; NaN: no lengths
  double height = 1;                 ///< meters in one of z
  std::string plan_name = "metre";   ///< "degree", "US survey foot", ...
  std::string height_name = "metre"; ///< the same for z
  bool height_stated = true;         ///< else z is taken to count as x and y do

  /** \brief Whether every unit is the meter. */
  bool
  areMeters() const
  {
    return plan == 1 && height == 1;
  }
};

/** \brief The units of the reference system \a wkt: those of its horizontal and of its
 * vertical part. Meters where it is empty or cannot be understood. */
Units
unitsOf(const std::string& wkt);

/** \brief Why lengths in the plan of \a cloud mean nothing, as a clause to follow the
 * name of its file: its reference system counts in degrees, or none is told and the
 * coordinates look like it. Empty where they are lengths for all that is known. */
std::string
degreesIn(const Cloud& cloud);

} // namespace io
} // namespace linelet
