// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief Where a file is written until it is complete: under a temporary name beside
 * its own, or directly if it is a device or a pipe. Unless published, it is removed on
 * destruction, along with what other writers (GDAL) put beside it. */
class StagedFile {
public:
  /** \throws FileError if \a path is a folder, or if its name is too long */
  explicit StagedFile(const std::string& path);
  ~StagedFile();
  StagedFile(const StagedFile&) = delete;
  StagedFile&
  operator=(const StagedFile&) = delete;

  const std::string&
  place() const
  {
    return place_;
  }

  /** \brief Whether the file is written in place. */
  bool
  direct() const
  {
    return place_ == path_;
  }

  /** \brief The file is complete: moves it into place. \throws FileError */
  void
  publish();

private:
  std::string path_, place_;
};

} // namespace io
} // namespace linelet
