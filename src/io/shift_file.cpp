// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "shift_file.h"

#include <filesystem>
#include <string_view>
#include <system_error>

#include <linelet/io/file_error.h>
#include <linelet/io/output_file.h>

#include "files.h"
#include "io/text_scan.h"

namespace linelet::io {

namespace {

std::string
pathOfShift(const std::string& path)
{
  return path + ".shift";
}

} // namespace

Point
readShift(const std::string& path)
{
  const std::string beside = pathOfShift(path);
  if (std::error_code ignored; !std::filesystem::exists(beside, ignored))
    return Point::Zero();
  const MappedFile file(beside);
  std::string_view text = file.bytes();
  Point shift;
  bool whole = true;
  for (int axis = 0; axis < 3; ++axis)
    whole = parseNumber(takeWord(text, " \t\r\n"), shift[axis]) && whole;
  if (!whole || !takeWord(text, " \t\r\n").empty() || !shift.allFinite())
    throw FileError(beside +
                    ": does not hold the three numbers of a shift; correct it, "
                    "or remove it if " +
                    path + " is in world coordinates");
  return shift;
}

void
writeShift(const std::string& path, const Point& shift)
{
  const std::string beside = pathOfShift(path);
  if (shift == Point::Zero()) {
    std::error_code ignored; // usually there is none
    std::filesystem::remove(beside, ignored);
    return;
  }
  std::string text;
  appendPoint(text, shift);
  text += '\n';
  OutputFile file(beside);
  file.write(text);
  file.commit();
}

} // namespace linelet::io
