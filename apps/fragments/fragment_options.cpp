// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fragment_options.h"

#include <cctype>
#include <cmath>
#include <stdexcept>

#include <unistd.h>

namespace linelet::apps {

namespace {

double
parsed(const std::string& text)
{
  if (text == "auto")
    return 0.5 * static_cast<double>(::sysconf(_SC_PHYS_PAGES)) *
           static_cast<double>(::sysconf(_SC_PAGE_SIZE));
  std::size_t used = 0;
  double bytes = 0;
  try {
    bytes = std::stod(text, &used);
  }
  catch (const std::exception&) {
  }
  double unit = 1;
  if (used + 1 == text.size())
    switch (std::toupper(static_cast<unsigned char>(text.back()))) {
    case 'T':
      unit *= 1024;
      [[fallthrough]];
    case 'G':
      unit *= 1024;
      [[fallthrough]];
    case 'M':
      unit *= 1024;
      [[fallthrough]];
    case 'K':
      unit *= 1024;
      ++used;
      break;
    default:
      break;
    }
  bytes *= unit;
  if (used != text.size() || !(bytes > 0) || !std::isfinite(bytes))
    throw std::invalid_argument("'" + text +
                                "' is not an amount of memory; give 8G, 500M or auto");
  return bytes;
}

} // namespace

MemorySize::MemorySize(std::string_view text) : text_(text), bytes_(parsed(text_)) {}

} // namespace linelet::apps
