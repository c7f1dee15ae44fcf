// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::io {

/** \brief A file that cannot be read or written. what() is one sentence that names the
 * file, what is wrong and where, and what to do. */
class FileError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief How to read a point file. */
struct ReadOptions {
  bool lenient = false; ///< read what is whole of a file that ends too early
};

template <class Visit>
void
describe(ReadOptions& s, Visit&& visit)
{
  visit("lenient", s.lenient, "read what is whole of a file that ends too early");
}

/** \brief How to write a point file. */
struct WriteOptions {
  /// Write coordinates less the shift of the cloud, which goes into a file beside, PATH
  /// with .shift behind, where \ref readCloud finds it. Not for LAS, which has its own.
  bool shifted = false;
};

template <class Visit>
void
describe(WriteOptions& s, Visit&& visit)
{
  visit("shifted",
        s.shifted,
        "write coordinates less a shift, small enough for the floats of PCL, and the "
        "shift to OUTPUT.shift, where linelet finds it again (not for .las)");
}

/** \brief Reads .las, .pcd, .ply, .xyz/.txt/.csv or the vertices of .obj, by ending;
 * with a file of its shift beside it (see \ref WriteOptions) in world coordinates.
 * \param[in] path the file
 * \param[in] options see there
 * \param[out] warnings one sentence for every loss (null: not wanted)
 * \throws FileError */
Cloud
readCloud(const std::string& path,
          const ReadOptions& options = {},
          std::vector<std::string>* warnings = nullptr,
          ProgressMonitor* monitor = nullptr);

/** \brief Writes \a cloud in the format that the ending of \a path names, and removes
 * a file of a shift that was there for another cloud.
 * \param[out] warnings one sentence for every attribute the format cannot hold
 * \throws FileError */
void
writeCloud(const std::string& path,
           const Cloud& cloud,
           const WriteOptions& options = {},
           std::vector<std::string>* warnings = nullptr,
           ProgressMonitor* monitor = nullptr);

} // namespace linelet::io
