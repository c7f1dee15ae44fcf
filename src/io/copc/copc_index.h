// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "io/laz/chunk_table.h"
#include "io/window.h"

namespace linelet::io {

/** \brief The octree over the chunks of a COPC file (cloud optimized point cloud 1.0,
 * copc.io): each node is a chunk, and deeper levels add density. */
class CopcIndex {
public:
  /** \brief Reads it. \param[in] info data of the record "copc" 1
   * \throws laz::Error if it does not fit the file */
  CopcIndex(std::string_view file, std::string_view info);

  /** \brief Number of levels. */
  int
  levels() const
  {
    return levels_;
  }

  /** \brief The chunks of nodes that intersect \a window and are needed for points \a
   * resolution apart (0: all), in the order of the file. */
  std::vector<laz::Chunk>
  chunks(const Window& window, double resolution) const;

private:
  struct Node {
    std::int32_t level, x, y, z;
    std::uint64_t at;
    std::uint32_t bytes, points;
  };

  struct Page {
    std::uint64_t at, bytes;
  };

  /** Adds the nodes of \a page, and appends the pages it refers to to \a pages. */
  void
  readPage(std::string_view file, Page page, std::vector<Page>& pages);

  Point low_; ///< corner of the cube
  double side_ = 0, spacing_ = 0;
  int levels_ = 0;
  std::vector<Node> nodes_;
  std::size_t entries_ = 0; ///< read so far
};

} // namespace linelet::io
