// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "handle.h"

namespace linelet::io::hdf5 {

/** \brief Checks the chunks of a dataset before the library reads them.
 *
 * HDF5 1.10 trusts that a chunk holds its rows, and reads past the end of one that is
 * stored shorter or decompresses to less. */
class ChunkCheck {
public:
  ChunkCheck() = default;

  /** \param[in] width values in a row
   * \param[in] value_bytes size of one in the file */
  ChunkCheck(const Handle& dataset,
             std::size_t width,
             std::size_t value_bytes,
             const std::string& name);

  /** \brief Checks the chunks of these rows, each once.
   * \throws Error if one is too short */
  void
  rows(const Handle& dataset, std::size_t first, std::size_t count);

private:
  void
  chunk(const Handle& dataset, hsize_t row, hsize_t column) const;

  std::string name_;
  std::size_t chunk_rows_ = 0; ///< 0: not chunked
  std::size_t chunk_width_ = 1, width_ = 1;
  std::size_t chunk_bytes_ = 0, file_bytes_ = 0;
  int deflate_ = -1; ///< place of this filter in the pipeline
  std::vector<bool> checked_;
};

} // namespace linelet::io::hdf5
