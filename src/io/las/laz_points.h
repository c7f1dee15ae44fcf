// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <linelet/io/output_file.h>

#include "io/laz/layout.h"

namespace linelet::io {

/** \brief The chunks of \a count points, compressed in several threads; \a records
 * makes the records of a given range of them.
 * \param[in] threads 0: all */
std::vector<std::vector<std::uint8_t>>
encodeChunks(
    const laz::Layout& layout,
    std::size_t count,
    const std::function<std::string(std::size_t first, std::size_t number)>& records,
    unsigned threads);

/** \brief The compressed points of a file to write. */
class LazPoints {
public:
  /** \param[in] threads 0: all */
  LazPoints(laz::Layout layout, unsigned threads)
      : layout_(std::move(layout)), threads_(threads)
  {
  }

  /** \brief Compresses \a count points in several threads; \a records makes the records
   * of a given range of them. */
  void
  encode(
      std::size_t count,
      const std::function<std::string(std::size_t first, std::size_t number)>& records);

  /** \brief Bytes in the file. */
  std::uint64_t
  size() const;

  /** \brief Writes them to \a file, where they start at byte \a place. */
  void
  write(OutputFile& file, std::uint64_t place) const;

private:
  laz::Layout layout_;
  unsigned threads_;
  std::vector<std::vector<std::uint8_t>> chunks_;
  std::vector<std::uint8_t> table_;
};

} // namespace linelet::io
