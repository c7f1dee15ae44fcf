// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fields.h"
#include "layout.h"

namespace linelet::laz {

/** \brief Decodes the \a count points in \a bytes to contiguous \a records. \a wanted
 * has no effect in point formats 0 to 5.
 * \return number of bytes used
 * \throws Error if the data ends too early, or if layers do not match their sizes */
std::size_t
readChunk(const Layout& layout,
          std::string_view bytes,
          std::size_t count,
          std::uint8_t* records,
          Fields wanted = field::all);

/** \brief Decodes the points of a chunk without keeping them, to check that the data
 * holds that many. \return number of bytes used \throws Error */
std::size_t
skipChunk(const Layout& layout, std::string_view bytes, std::size_t count);

/** \brief Size in bytes and points of a chunk of point formats 6 to 10 that begins with
 * \a bytes. \throws Error */
struct ChunkSize {
  std::size_t bytes;
  std::uint32_t points;
};
ChunkSize
layeredChunkSize(const Layout& layout, std::string_view bytes);

} // namespace linelet::laz
