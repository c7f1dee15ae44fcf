// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/source.h"
#include "io/text_scan.h"

namespace linelet::io {

/** \brief Words of a text, regardless of lines. */
class ScannedWords {
public:
  explicit ScannedWords(const Source& source) : source_(source), rest_(source.bytes) {}

  std::string_view
  next()
  {
    return takeWord(rest_, " \t\r\n");
  }

  template <class T>
  T
  number(const char* of)
  {
    const std::string_view word = next();
    T value{};
    if (!parseNumber(word, value))
      source_.fail(word.empty() ? std::string("it ends before its ") + of
                                : "'" + cleanName(word.substr(0, 40)) +
                                      "' is not a number of its " + of);
    return value;
  }

  Point
  point(const char* of)
  {
    Point p;
    for (double& value : p.reshaped())
      value = number<double>(of);
    return p;
  }

private:
  const Source& source_;
  std::string_view rest_;
};

/** \brief \a value as an index below \a count. */
inline std::size_t
placeOf(const Source& source, double value, std::size_t count)
{
  if (!(value >= 0 && value < static_cast<double>(count)))
    source.fail("a line has the vertex " + std::to_string(value) + " of " +
                std::to_string(count));
  return static_cast<std::size_t>(value);
}

} // namespace linelet::io
