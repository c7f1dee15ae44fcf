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

/** \brief A file under construction. Nothing stands at its path before \ref commit;
 * without it, nothing stays. */
class OutputFile {
public:
  /** \throws FileError where no file can be made at \a path */
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile&
  operator=(const OutputFile&) = delete;

  /** \throws FileError if the disk is full */
  void
  write(std::string_view bytes);

  /** \brief Writes \a bytes over those at \a place, written before. Not for pipes.
   * \throws FileError */
  void
  rewrite(std::size_t place, std::string_view bytes);

  /** \brief The file is whole: put it in its place. \throws FileError */
  void
  commit();

private:
  [[noreturn]] void
  fail();

  std::string path_;
  std::unique_ptr<StagedFile> staged_;
  std::FILE* file_ = nullptr;
};

/** \brief Fails where no file can be made at \a path; makes none. \throws FileError */
void
checkWritable(const std::string& path);

/** \brief Removes what processes of this machine that were killed left under
 * construction in \a folder. */
void
removeLeftovers(const std::string& folder);

/** \brief Removes all files under construction, by whatever writer; none is made or
 * published afterwards. For a program that ends at once, from any of its threads. */
void
removeUnfinishedFiles();

} // namespace io
} // namespace linelet
