// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <boost/endian/conversion.hpp>

#include <linelet/io/cloud.h>
#include <linelet/io/file_options.h>
#include <linelet/support/visibility.h>

#include "file_work.h"

namespace linelet::io {

/** \brief The bytes of a file to read.
 *
 * Readers work on memory: a mapped file, or the input of a fuzzer. */
struct Source : FileWork {
  std::string_view bytes;
  ReadOptions options;
  /// LAS: only the blocks (chunks) that begin at these points of the file.
  std::size_t first = 0, behind = static_cast<std::size_t>(-1);
  std::size_t* passed =
      nullptr; ///< LAS: if not null, receives the number of points in these

  /** \throws FileError "NAME: WHAT" */
  [[noreturn]] void
  fail(const std::string& what) const
  {
    throw FileError(name + ": " + what);
  }

  /** \brief Reports that the file ends early: an error, or with `lenient` a warning. */
  void
  endsEarly(const std::string& what) const
  {
    if (!options.lenient)
      fail(what + "; --lenient reads what is whole");
    warn(what);
  }
};

/** \brief Value at \a at in the byte order of the file. */
template <class T, boost::endian::order Order = boost::endian::order::little>
T
load(const char* at)
{
  return boost::endian::endian_load<T, sizeof(T), Order>(
      reinterpret_cast<const unsigned char*>(at));
}

template <class T, boost::endian::order Order = boost::endian::order::little>
void
store(char* at, T value)
{
  boost::endian::endian_store<T, sizeof(T), Order>(reinterpret_cast<unsigned char*>(at),
                                                   value);
}

/** \brief \a text as a name: valid UTF-8 without control characters, trimmed. */
LINELET_PUBLIC std::string
cleanName(std::string_view text);

/** \brief Assigns unique names. */
class LINELET_PUBLIC UniqueNames {
public:
  /** \brief \a asked, with _2, _3, ... appended if that is taken. */
  std::string
  take(const std::string& asked);

private:
  std::map<std::string, int> used_; ///< name -> largest number appended to it
};

/** \brief Number of points between two checks of the monitor. */
constexpr std::size_t block_points = 8192;

} // namespace linelet::io
