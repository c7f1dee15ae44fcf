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

/** \brief Parts of a cloud that cannot share one LAS file as they are, although the
 * whole cloud fits. */
class PartsDiffer : public FileError {
public:
  using FileError::FileError;
};

/** \brief Writes a LAS or LAZ file part by part: byte for byte what \ref writeCloud
 * writes for all parts together. */
class CloudSink {
public:
  /** \brief Whether \a path, by its ending, can be written this way. */
  static bool
  takes(const std::string& path);

  /** \param[in] threads that make and compress records; 0: all
   * \throws FileError unless it \ref takes \a path */
  explicit CloudSink(const std::string& path,
                     std::vector<std::string>* warnings = nullptr,
                     ProgressMonitor* monitor = nullptr,
                     unsigned threads = 0);
  ~CloudSink();

  /** \brief Adds the points of \a cloud, which must have the same columns as those
   * before.
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
