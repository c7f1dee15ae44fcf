// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "layout.h"

namespace linelet::laz {

/** \brief A range of points that is coded independently. */
struct Chunk {
  std::size_t at;           ///< byte of the file
  std::size_t bytes;        ///< upper bound of its size
  bool exact;               ///< whether the bound is its exact size
  std::size_t first, count; ///< its points
};

/** \brief The chunks of a file. */
struct ChunkTable {
  std::vector<Chunk> chunks;
  std::size_t points = 0; ///< in all chunks
  std::string
      problem; ///< why there may be fewer points than the header states, or empty
};

/** \brief Finds the chunks that hold the first \a count points of \a file, whose points
 * begin at byte \a points_at. Every chunk lies in the file, and their number is bounded
 * by its size. \throws Error */
ChunkTable
readChunkTable(std::string_view file,
               std::size_t points_at,
               std::uint64_t count,
               const Layout& layout);

/** \brief Checks that \a chunk, taken from another index, lies in \a file and can have
 * its points. \throws Error */
void
checkChunk(std::string_view file, const Chunk& chunk, const Layout& layout);

/** \brief The table after chunks of \a sizes bytes, of a fixed number of points each.
 */
std::vector<std::uint8_t>
writeChunkTable(const std::vector<std::uint32_t>& sizes);

} // namespace linelet::laz
