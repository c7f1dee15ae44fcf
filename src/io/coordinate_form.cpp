// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "coordinate_form.h"

#include <algorithm>
#include <cmath>

#include "io/text_scan.h"

namespace linelet::io {

namespace {

constexpr int most_decimals = 9;
constexpr double double_rounding = 0x1p-51; // a few roundings of a double
constexpr double float_rounding = 0x1p-24;  // one rounding to float

/** Calls f(world coordinate) for all finite ones until it returns false. */
template <class F>
bool
allCoordinates(const Cloud& cloud, F f)
{
  return std::all_of(cloud.points.begin(), cloud.points.end(), [&](const Point& point) {
    for (int axis = 0; axis < 3; ++axis) {
      const double value = cloud.shift[axis] + point[axis];
      if (std::isfinite(value) && !f(value, std::abs(cloud.shift[axis])))
        return false;
    }
    return true;
  });
}

} // namespace

CoordinateForm
formOf(const Cloud& cloud)
{
  CoordinateForm form;
  form.floats = allCoordinates(cloud, [](double value, double) {
    return static_cast<double>(static_cast<float>(value)) == value;
  });
  const double rounding = form.floats ? float_rounding : double_rounding;
  double unit = 1;
  for (int decimals = 0; decimals <= most_decimals; ++decimals, unit *= 10) {
    const bool told = allCoordinates(cloud, [&](double value, double shift) {
      const double error = rounding * (std::abs(value) + shift);
      return error * unit < 0.25 &&
             std::abs(std::round(value * unit) / unit - value) <= error;
    });
    if (told) {
      form.decimals = decimals;
      break;
    }
  }
  form.fits_float =
      form.floats ||
      (form.decimals >= 0 && allCoordinates(cloud, [&](double value, double) {
         return std::abs(value) * float_rounding * unit < 0.25;
       }));
  return form;
}

void
appendCoordinate(std::string& text, double value, const CoordinateForm& form)
{
  if (form.decimals < 0 || !std::isfinite(value)) {
    if (form.floats)
      appendNumber(text, static_cast<float>(value));
    else
      appendNumber(text, value);
    return;
  }
  char buffer[400];
  const auto result = std::to_chars(
      buffer, buffer + sizeof buffer, value, std::chars_format::fixed, form.decimals);
  text.append(buffer, result.ptr);
}

} // namespace linelet::io
