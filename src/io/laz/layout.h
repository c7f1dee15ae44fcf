// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "error.h"

namespace linelet::laz {

/** \brief One of the parts into which a point record is split for coding. */
struct Item {
  enum Type : unsigned {
    Byte = 0,
    Point10 = 6,
    GpsTime11,
    Rgb12,
    WavePacket13,
    Point14,
    Rgb14,
    RgbNir14,
    WavePacket14,
    Byte14
  };
  Type type;
  std::size_t size;
  unsigned version;
};

constexpr std::string_view record_user = "laszip encoded";
constexpr unsigned record_number = 22204;

/** \brief How the points of a file are coded, according to its record "laszip
 * encoded". */
struct Layout {
  enum Compressor : unsigned { Pointwise = 1, Chunked = 2, Layered = 3 };
  static constexpr std::uint32_t variable = 0xFFFFFFFFU; ///< chunks of any size
  static constexpr std::uint32_t usual_chunk = 50000;

  Compressor compressor = Chunked;
  std::uint32_t chunk_size = usual_chunk; ///< points, or \ref variable
  std::vector<Item> items;

  bool
  layered() const
  {
    return compressor == Layered;
  }

  /** \brief Length of a point record in a LAS file. */
  std::size_t
  recordLength() const;
};

/** \brief The layout stated in the record's \a data, after checking that it fits point
 * format \a format with \a record_length bytes. \throws Error */
Layout
parseLayout(std::string_view data, int format, std::size_t record_length);

/** \brief The layout to write: versions 2 and 3 of the items, in fixed chunks. */
Layout
layoutFor(int format, std::size_t record_length);

/** \brief The data of the record. */
std::string
textOf(const Layout& layout);

} // namespace linelet::laz
