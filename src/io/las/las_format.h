// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <linelet/io/cloud.h>

#include "io/laz/layout.h"
#include "io/values.h"
#include "las_extra.h"

namespace linelet::io {

/** \brief Steps of the scan angle in point formats 6 to 10, degrees. */
constexpr double las_angle_step = 0.006;

/** \brief Where an attribute lies in a point record: a whole value, or for \a bits > 0
 * some bits of a byte. */
struct LasField {
  std::string_view name;
  ValueType type; ///< as stored; scan_angle as Int16 counts steps
  std::size_t byte;
  unsigned shift = 0;
  unsigned bits = 0;

  /** \brief Whether the values are angles in steps instead of degrees. */
  bool
  isAngleStep() const
  {
    return name == "scan_angle" && type == ValueType::Int16;
  }
};

/** \brief Length of a record of point format 0 to 10 without extra bytes. */
std::size_t
lasRecordLength(int format);

/** \brief The attributes of point format 0 to 10, without the coordinates. */
const std::vector<LasField>&
lasFields(int format);

/** \brief Whether \a name is an attribute of some point format, except those of
 * waveforms. */
bool
isLasName(std::string_view name);

bool
hasWaveform(int format);

/** \brief A variable length record as stored in the file. */
struct LasRecord {
  std::string head; ///< 54 bytes, or 60 after the points
  std::string data;

  std::string_view
  user() const;
  unsigned
  number() const;
  bool
  is(std::string_view user_id, unsigned record_id) const
  {
    return user() == user_id && number() == record_id;
  }
};

LasRecord
makeLasRecord(std::string_view user,
              unsigned number,
              std::string_view description,
              std::string data);

/** \brief The integer grid of the coordinates: world = scale * integer + offset. */
struct LasGrid {
  Point scale = Point::Constant(0.001);
  Point offset = Point::Zero();
  std::array<std::int64_t, 3> corner{}; ///< the integers at Cloud::shift

  Point
  shift() const;
};

struct LasOrigin {
  std::string header; ///< header_size bytes, as in the file
  int format = 0;
  std::vector<LasRecord> records, extended;
  std::string gap; ///< bytes between the last record and the points
  std::vector<LasExtra> extras;
  LasGrid grid;
  std::optional<laz::Layout> compression; ///< of a LAZ file
  int copc_levels = 0;                    ///< of its octree; 0: none
  Point shift;                            ///< Cloud::shift as the reader set it
  std::string wkt;                        ///< Cloud::wkt as the reader set it
};

} // namespace linelet::io
