// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cctype>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

#include "source.h"
#include "values.h"

namespace linelet::io {

/** \brief Reads a text line by line; LF, CRLF and CR end a line. */
class Lines {
public:
  explicit Lines(std::string_view text) : rest_(text) {}

  /** \brief Puts the next line, without its end, into \a line; false after the last. */
  bool
  next(std::string_view& line)
  {
    if (rest_.empty())
      return false;
    ++number_;
    const std::size_t end = rest_.find_first_of("\r\n");
    line = rest_.substr(0, end);
    if (end == std::string_view::npos)
      rest_ = {};
    else
      rest_.remove_prefix(end + (rest_.substr(end, 2) == "\r\n" ? 2 : 1));
    return true;
  }

  /** \brief Number of the last line read, from 1. */
  std::size_t
  number() const
  {
    return number_;
  }

  /** \brief The text not read yet. */
  std::string_view
  rest() const
  {
    return rest_;
  }

private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/** \brief Removes the next word, delimited by any of \a gaps, from the front of \a
 * line; empty if there is none. */
inline std::string_view
takeWord(std::string_view& line, std::string_view gaps = " \t")
{
  const std::size_t begin = line.find_first_not_of(gaps);
  if (begin == std::string_view::npos) {
    line = {};
    return {};
  }
  line.remove_prefix(begin);
  const std::size_t end = line.find_first_of(gaps);
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(word.size());
  return word;
}

/** \brief Whether all of \a word is a number, in any locale: "1.5", "+2e3", "nan". */
template <class T>
bool
parseNumber(std::string_view word, T& value)
{
  if (word.size() > 1 && word.front() == '+' && word[1] != '-')
    word.remove_prefix(1);
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  return !word.empty() && result.ec == std::errc() &&
         result.ptr == word.data() + word.size();
}

/** \brief Whether \a word is a value of T, even if written as a real number: 3.0 for 3.
 */
template <class T>
bool
parseValue(std::string_view word, T& value)
{
  if (parseNumber(word, value))
    return true;
  double real = 0;
  if (!parseNumber(word, real) || !representable<T>(real))
    return false;
  value = static_cast<T>(real);
  return true;
}

/** \brief The message that \a word is not a value of the attribute \a name. */
inline std::string
noValue(std::string_view word, const std::string& name)
{
  return word.empty() ? "there is no value for '" + name + "'"
                      : "'" + cleanName(word.substr(0, 40)) + "' is not a value for '" +
                            name + "'";
}

/** \brief Appends the shortest text that reads back as the same value. */
template <class T>
void
appendNumber(std::string& text, T value)
{
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, result.ptr);
}

/** \brief Appends coordinates, \a gap between them. */
template <class Vector>
void
appendPoint(std::string& text, const Vector& point, char gap = ' ')
{
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0)
      text += gap;
    appendNumber(text, static_cast<double>(point[axis]));
  }
}

} // namespace linelet::io
