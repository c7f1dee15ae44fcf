// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/io/file_error.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief Parts of a cloud cannot stand in one LAS file record by record; in one piece
 * they can. */
class PartsDiffer : public FileError {
public:
  using FileError::FileError;
};

/** \brief Writes a LAS or LAZ file a part at a time: byte for byte what \ref writeCloud
 * makes of all parts together. */
class CloudSink {
public:
  /** \brief Whether \a path, by its ending, can be written so. */
  static bool
  takes(const std::string& path);

  /** \param[in] threads to make and compress records in; 0: all
   * \throws FileError unless it \ref takes it */
  explicit CloudSink(const std::string& path,
                     std::vector<std::string>* warnings = nullptr,
                     ProgressMonitor* monitor = nullptr,
                     unsigned threads = 0);
  ~CloudSink();

  /** \brief Adds the points of \a cloud, which has the columns of those before.
   * \throws PartsDiffer if it does not match them */
  void
  add(const Cloud& cloud);

  /** \brief Completes the file and moves it into place. \throws FileError also if
   * nothing was added */
  void
  commit();

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace io
} // namespace linelet
