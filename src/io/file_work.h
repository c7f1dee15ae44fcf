// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <linelet/io/file_error.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::io {

/** \brief A file being processed, and where to report about it. */
struct FileWork {
  std::string name; ///< path, for messages
  std::vector<std::string>* warnings = nullptr;
  ProgressMonitor* monitor = nullptr;
  unsigned threads = 0; ///< to write in; 0: all

  void
  warn(const std::string& what) const
  {
    if (warnings != nullptr)
      warnings->push_back(name + ": " + what);
  }

  /** \brief Reports \a steps more points to the monitor. \throws Canceled */
  void
  advance(std::size_t steps) const
  {
    if (monitor == nullptr)
      return;
    monitor->advance(steps);
    if (monitor->canceled())
      throw Canceled();
  }
};

/** \brief A point file to write. */
using Target = FileWork;

} // namespace linelet::io
