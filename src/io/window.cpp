// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "window.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

#include <linelet/io/file_error.h>

#include "io/las/las_format.h"

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

void
crop(Cloud& cloud, const Window& window)
{
  if (!window.limits())
    return;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (window.contains(cloud.shift + cloud.points[i]))
      kept.push_back(i);
  if (kept.size() == cloud.points.size())
    return;
  const auto choose = [&kept](auto& values) {
    for (std::size_t k = 0; k < kept.size(); ++k)
      values[k] = values[kept[k]];
    values.resize(kept.size());
  };
  choose(cloud.points);
  for (Column& column : cloud.columns)
    std::visit(choose, column.values);
  if (cloud.las == nullptr)
    return;
  auto las = std::make_shared<LasOrigin>(*cloud.las);
  for (LasExtra& extra : las->extras) {
    std::string raw;
    for (std::size_t k = 0; k < kept.size() && !extra.raw.empty(); ++k)
      raw.append(extra.raw, kept[k] * extra.bytes, extra.bytes);
    extra.raw = std::move(raw);
  }
  cloud.las = std::move(las);
}

} // namespace linelet::io
