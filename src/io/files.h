// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief A file in memory, read-only: mapped if it is a regular file. */
class MappedFile {
public:
  /** \throws FileError, Canceled */
  explicit MappedFile(const std::string& path,
                      const ProgressMonitor* monitor = nullptr);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile&
  operator=(const MappedFile&) = delete;

  std::string_view
  bytes() const
  {
    return bytes_;
  }

private:
  std::string_view bytes_;
  std::string owned_; ///< content of files that cannot be mapped (pipes)
  void* mapped_ = nullptr;
};

/** \brief The sentence for a file that cannot be written, from errno. */
std::string
cannotWrite(const std::string& path, int error);

/** \brief The ending of \a path in lower case, with its dot. */
std::string
endingOf(const std::string& path);

} // namespace io
} // namespace linelet
