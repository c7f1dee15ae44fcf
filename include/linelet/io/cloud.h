// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <linelet/support/points.h>

namespace linelet::io {

/** \brief The values of one attribute, one a point, in the type they had in the file.
 */
using Values = std::variant<std::vector<std::int8_t>,
                            std::vector<std::uint8_t>,
                            std::vector<std::int16_t>,
                            std::vector<std::uint16_t>,
                            std::vector<std::int32_t>,
                            std::vector<std::uint32_t>,
                            std::vector<std::int64_t>,
                            std::vector<std::uint64_t>,
                            std::vector<float>,
                            std::vector<double>>;

/** \brief Number of values. */
std::size_t
size(const Values& values);

/** \brief int8, uint8, ... uint64, float32 or float64. */
std::string_view
typeName(const Values& values);

/** \brief A named attribute of every point.
 *
 * Attributes that several formats know carry one name each, in snake_case: intensity,
 * return_number, number_of_returns, classification, scan_angle (degrees), user_data,
 * point_source_id, gps_time, red, green, blue, nir, and the flags synthetic, key_point,
 * withheld, overlap, scanner_channel, scan_direction, edge_of_flight_line. Every other
 * name is kept as the file has it. */
struct Column {
  std::string name;
  Values values;
  std::string description; ///< what LAS extra bytes say of it; may be empty
};

struct LasOrigin; // what a LAS to LAS trip must keep beside points and columns

/** \brief A point cloud with everything its file said.
 *
 * World coordinates are `shift + points[i]`. The shift is chosen by the reader so that
 * points are small; nothing is ever stored as a large float. */
struct Cloud {
  Point shift = Point::Zero(); ///< in the units of the file, added on output
  Points points;               ///< relative to shift; NaN where the file has NaN
  std::vector<Column> columns; ///< each as long as points
  std::string wkt;             ///< coordinate reference system (WKT), empty: unknown
  std::string format; ///< what the file was, in words: "LAS 1.4, point format 7"
  std::shared_ptr<const LasOrigin> las; ///< set where the cloud came from LAS

  /** \brief The column called \a name, or null. */
  const Column*
  find(std::string_view name) const;
  Column*
  find(std::string_view name);

  /** \brief Adds a column, or replaces the one of that name.
   * \throws std::invalid_argument unless it is as long as points */
  void
  set(Column column);
};

/** \brief The value of \a column at point \a i, as a double. */
double
valueAt(const Column& column, std::size_t i);

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

} // namespace linelet::io
