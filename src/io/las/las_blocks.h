// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/laz/chunk_table.h"
#include "io/laz/fields.h"
#include "io/source.h"
#include "las_header.h"

namespace linelet::io {

/** \brief Consecutive point records. */
struct RecordBlock {
  const char* records;
  std::size_t stride;
  std::size_t first, count; ///< of the points of the file

  const char*
  record(std::size_t i) const
  {
    return records + i * stride;
  }
};

/** \brief The point records of a LAS or LAZ file, block by block: as stored in the
 * file, or decompressed chunk by chunk. */
class LasBlocks {
public:
  /** Finds the blocks; \a header holds the number of points, and is updated to the
   * number of complete ones. */
  LasBlocks(const Source& source, const LasOrigin& origin, LasHeader& header);

  /** \brief The same for chosen chunks, for example those that an index selects. */
  LasBlocks(const Source& source,
            const LasOrigin& origin,
            const LasHeader& header,
            std::vector<laz::Chunk> chunks);

  /** \brief Keeps only the blocks that begin at point \a first or later, and before \a
   * behind. */
  void
  keep(std::size_t first, std::size_t behind);

  /** \brief Number of blocks. */
  std::size_t
  size() const
  {
    return blocks_.size();
  }

  /** \brief Number of points in all of them. */
  std::size_t
  points() const
  {
    return blocks_.empty() ? 0 : blocks_.back().first + blocks_.back().count;
  }

  /** \brief The first record of all, or null. */
  const char*
  firstRecord() const;

  /** \brief Calls \a use for every block, in several threads at once and in any order;
   * with \a worth, only for those where it returns true. \a worth gets blocks in which
   * only the coordinates may be decoded; \a use gets coordinates and the layers \a
   * wanted. */
  void
  forEach(laz::Fields wanted,
          const std::function<void(std::size_t number, const RecordBlock& block)>& use,
          const std::function<bool(const RecordBlock& block)>& worth = {}) const;

private:
  void
  load(const laz::Chunk& chunk, std::string& records, laz::Fields wanted) const;

  const Source& source_;
  const std::optional<laz::Layout>& layout_;
  std::size_t stride_;
  std::vector<laz::Chunk> blocks_;
};

} // namespace linelet::io
