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

#include <linelet/io/reference_system.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief The values of one attribute, one per point, in the type they had in the file.
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
 * Attributes that several formats have in common have one name, in snake_case:
 * intensity, return_number, number_of_returns, classification, scan_angle (degrees),
 * user_data, point_source_id, gps_time, red, green, blue, nir, and the flags synthetic,
 * key_point, withheld, overlap, scanner_channel, scan_direction, edge_of_flight_line.
 * Every other name is kept as the file has it. */
struct Column {
  std::string name;
  Values values;
  std::string description; ///< from LAS extra bytes; may be empty
};

struct LasOrigin; // what a copy from LAS to LAS must keep besides points and columns

/** \brief A point cloud with all attributes of its file.
 *
 * World coordinates are `shift + points[i]`. The shift is chosen by the reader so that
 * points are small and keep their precision. */
struct Cloud {
  Point shift = Point::Zero(); ///< in the units of the file, added on output
  Points points;               ///< relative to shift; NaN where the file has NaN
  std::vector<Column> columns; ///< each as long as points
  std::string wkt;             ///< coordinate reference system (WKT); empty: unknown
  std::string format;          ///< format of the file: "LAS 1.4, point format 7"
  std::shared_ptr<const LasOrigin> las; ///< set if the cloud came from LAS

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

} // namespace io
} // namespace linelet
