// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

class StagedFile;

/** \brief A file under construction. Nothing exists at its path before \ref commit, and
 * nothing remains without it. */
class OutputFile {
public:
  /** \throws FileError if no file can be created at \a path */
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile&
  operator=(const OutputFile&) = delete;

  /** \throws FileError if the disk is full */
  void
  write(std::string_view bytes);

  /** \brief Overwrites the bytes written earlier at \a place. Not for pipes.
   * \throws FileError */
  void
  rewrite(std::size_t place, std::string_view bytes);

  /** \brief The file is complete: moves it into place. \throws FileError */
  void
  commit();

private:
  [[noreturn]] void
  fail();

  std::string path_;
  std::unique_ptr<StagedFile> staged_;
  std::FILE* file_ = nullptr;
};

/** \brief Fails if no file can be created at \a path; creates none. \throws FileError
 */
void
checkWritable(const std::string& path);

} // namespace io
} // namespace linelet
