// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "window.h"

#include <algorithm>
#include <limits>
#include <string>

#include <linelet/io/file_error.h>

namespace linelet::io {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

void
limit(Window& window,
      const std::vector<double>& numbers,
      int axes,
      const std::string& name,
      const std::string& form)
{
  if (numbers.empty())
    return;
  if (numbers.size() != static_cast<std::size_t>(2 * axes))
    throw FileError(name + " has " + std::to_string(numbers.size()) +
                    " numbers; give " + form);
  for (int axis = 0; axis < axes; ++axis) {
    const double low = numbers[static_cast<std::size_t>(axis)];
    const double high = numbers[static_cast<std::size_t>(axes + axis)];
    if (!(low <= high))
      throw FileError(name + " is empty in " + "xyz"[axis] +
                      ": the first corner must be the lower one; give " + form);
    window.low[axis] = std::max(window.low[axis], low);
    window.high[axis] = std::min(window.high[axis], high);
  }
}

} // namespace

bool
Window::limits() const
{
  return (low.array() > -unlimited).any() || (high.array() < unlimited).any();
}

Window
windowOf(const ReadOptions& options)
{
  Window window{Point::Constant(-unlimited), Point::Constant(unlimited)};
  limit(window, options.bounds, 2, "--bounds", "X0,Y0,X1,Y1");
  limit(window, options.bounds_3d, 3, "--bounds-3d", "X0,Y0,Z0,X1,Y1,Z1");
  if (!(options.resolution >= 0))
    throw FileError("--resolution must be a length, not less than 0");
  return window;
}

} // namespace linelet::io
