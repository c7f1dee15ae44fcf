// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fields.h"
#include "layout.h"

namespace linelet::laz {

/** \brief Decodes the \a count points whose data are \a bytes, to \a records, which
 * follow one another without gaps. \a wanted has no effect in point formats 0 to 5.
 * \return number of bytes that were used
 * \throws Error if the data ends too early, or if the layers differ from their sizes */
std::size_t
readChunk(const Layout& layout,
          std::string_view bytes,
          std::size_t count,
          std::uint8_t* records,
          Fields wanted = field::all);

/** \brief Decodes the points of a chunk without keeping them, to check that the data
 * holds as many. \return number of bytes that were used \throws Error */
std::size_t
skipChunk(const Layout& layout, std::string_view bytes, std::size_t count);

/** \brief Number of bytes that a chunk of point formats 6 to 10 has, whose beginning is
 * that of \a bytes, and of its points. \throws Error */
struct ChunkSize {
  std::size_t bytes;
  std::uint32_t points;
};
ChunkSize
layeredChunkSize(const Layout& layout, std::string_view bytes);

} // namespace linelet::laz
