// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <utility>

#include "io/source.h"
#include "las_format.h"

namespace linelet::io {

// Places in the header of every version.
namespace las_at {
constexpr std::size_t global_encoding = 6, minor = 25, software = 58, header_size = 94,
                      points = 96, records = 100, format = 104, record_length = 105,
                      count = 107, returns = 111, scale = 131, offset = 155,
                      bounds = 179, waveform = 227, extended = 235,
                      extended_count = 243, count64 = 247, returns64 = 255;
} // namespace las_at

constexpr std::size_t las_header_10 = 227, las_header_13 = 235, las_header_14 = 375;
constexpr unsigned las_wkt_bit = 16; ///< in the global encoding

/** \brief What the front matter of a LAS file states about its points, checked. */
struct LasHeader {
  int minor = 0; ///< version 1.minor
  std::size_t points_at = 0;
  std::size_t record_length = 0;
  std::size_t count = 0; ///< complete points; in a compressed file, the stated number
};

/** \brief The smallest and largest coordinates stated in the header, unchecked. */
std::pair<double, double>
lasBounds(const LasOrigin& origin, int axis);

/** \brief The format as text: "LAZ 1.4, point format 7". */
std::string
formatName(const LasHeader& header, const LasOrigin& origin);

/** \brief Reads the header, the records and whatever follows the points into \a
 * origin. */
LasHeader
readLasHeader(const Source& source, LasOrigin& origin);

} // namespace linelet::io
