// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace linelet::apps {

Axis::Axis(double low, double high, double begin, double end, bool logarithmic)
    : low_(logarithmic ? std::log(low) : low),
      high_(logarithmic ? std::log(high) : high),
      begin_(begin),
      end_(end),
      logarithmic_(logarithmic)
{
  if (!(high_ > low_))
    high_ = low_ + 1;
}

double
Axis::pixel(double value) const
{
  const double position = logarithmic_ ? std::log(value) : value;
  return begin_ + (position - low_) / (high_ - low_) * (end_ - begin_);
}

std::vector<double>
Axis::ticks() const
{
  constexpr std::array<double, 3> steps = {1, 2, 5};
  constexpr double tolerance = 1e-9;
  std::vector<double> values;
  if (logarithmic_) {
    for (int power = static_cast<int>(std::floor(low_ / std::log(10.0)));
         std::pow(10.0, power) <= std::exp(high_);
         ++power)
      for (const double step : steps) {
        const double value = step * std::pow(10.0, power);
        if (std::log(value) >= low_ - tolerance && std::log(value) <= high_ + tolerance)
          values.push_back(value);
      }
    return values;
  }
  const double rough = (high_ - low_) / 7;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (auto it = steps.rbegin(); it != steps.rend(); ++it)
    if (*it * power >= rough)
      step = *it * power;
  for (double n = std::ceil(low_ / step - tolerance);
       n * step <= high_ + tolerance * step;
       ++n)
    values.push_back(n == 0 ? 0 : n * step);
  return values;
}

std::string
numberText(double value, int digits)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

void
drawAxes(Canvas& canvas,
         const Axis& x,
         const std::string& x_label,
         const Axis& y,
         const std::string& y_label,
         bool grid)
{
  constexpr double tick = 5;
  const double left = x.begin(), right = x.end(), bottom = y.begin(), top = y.end();
  for (const double value : x.ticks()) {
    const double at = x.pixel(value);
    if (grid)
      canvas.line({at, top}, {at, bottom}, 1, ink::grid);
    canvas.line({at, bottom}, {at, bottom + tick}, 1, ink::frame);
    canvas.text(
        {at, bottom + 16}, numberText(value), text_size, ink::text, Align::Center);
  }
  for (const double value : y.ticks()) {
    const double at = y.pixel(value);
    if (grid)
      canvas.line({left, at}, {right, at}, 1, ink::grid);
    canvas.line({left - tick, at}, {left, at}, 1, ink::frame);
    canvas.text({left - 9, at}, numberText(value), text_size, ink::text, Align::Right);
  }
  canvas.polyline(
      {{left, bottom}, {right, bottom}, {right, top}, {left, top}, {left, bottom}},
      1,
      ink::frame);
  canvas.text(
      {(left + right) / 2, bottom + 40}, x_label, text_size, ink::text, Align::Center);
  canvas.text({left - 62, (top + bottom) / 2},
              y_label,
              text_size,
              ink::text,
              Align::Center,
              true);
}

void
drawLegend(Canvas& canvas,
           Spot at,
           const std::vector<std::pair<Color, std::string>>& entries)
{
  constexpr double swatch = 14;
  for (const auto& [color, name] : entries) {
    canvas.rectangle({at.x, at.y - swatch / 2}, swatch, swatch, ink::frame);
    canvas.rectangle({at.x + 1, at.y - swatch / 2 + 1}, swatch - 2, swatch - 2, color);
    canvas.text({at.x + swatch + 7, at.y}, name, text_size);
    at.x += swatch + 7 + Canvas::textWidth(name, text_size) + 24;
  }
}

} // namespace linelet::apps
