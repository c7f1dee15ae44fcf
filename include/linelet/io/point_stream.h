// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/io/point_file.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief Reads a point file block by block, in its order. For LAS and LAZ, only one
 * block is in memory, each chunk is decoded once, and what the options exclude is
 * skipped; other formats are a single block. */
class PointStream {
public:
  /** \param[in] block approximate number of points to read at a time */
  PointStream(std::string path,
              ReadOptions options,
              std::size_t block = 1000000,
              std::vector<std::string>* warnings = nullptr,
              ProgressMonitor* monitor = nullptr);

  /** \brief LAS and LAZ: continues with the blocks (chunks) that begin at or after
   * point \a first of the file, and before \a behind. */
  void
  seek(std::size_t first, std::size_t behind);

  /** \brief Reads the next block, as \ref readCloud would the file; it may be empty.
   * \return whether there was one
   * \throws FileError, Canceled */
  bool
  next(Cloud& cloud);

private:
  bool
  nextOfLas(Cloud& cloud);

  std::string path_;
  ReadOptions options_;
  std::size_t block_, first_ = 0, behind_ = static_cast<std::size_t>(-1);
  bool begun_ = false, over_ = false;
  std::vector<std::string>* warnings_;
  ProgressMonitor* monitor_;
};

} // namespace io
} // namespace linelet
