// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "coloring.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "picture/color.h"

namespace linelet::view {

namespace {

using apps::Color;

constexpr Color unknown = {0.62, 0.62, 0.64};

void
put(std::vector<std::uint8_t>& rgb, std::size_t i, const Color& color)
{
  for (std::size_t c = 0; c < 3; ++c)
    rgb[3 * i + c] = static_cast<std::uint8_t>(std::lround(255 * color[c]));
}

template <class ColorOf>
Coloring
colored(std::size_t count, const ColorOf& color_of)
{
  Coloring result;
  result.rgb.resize(3 * count);
  for (std::size_t i = 0; i < count; ++i)
    put(result.rgb, i, color_of(i));
  return result;
}

struct ClassLook {
  int number;
  const char* name;
  Color color;
};

/// Names of LAS 1.4 R15, table 17.
constexpr std::array<ClassLook, 20> class_looks = {
    {{0, "never classified", {0.72, 0.72, 0.72}},
     {1, "unclassified", {0.66, 0.66, 0.68}},
     {2, "ground", {0.63, 0.51, 0.36}},
     {3, "low vegetation", {0.65, 0.82, 0.50}},
     {4, "medium vegetation", {0.40, 0.70, 0.34}},
     {5, "high vegetation", {0.15, 0.50, 0.22}},
     {6, "building", {0.85, 0.45, 0.30}},
     {7, "low noise", {0.95, 0.20, 0.75}},
     {8, "model key point", {0.45, 0.40, 0.35}},
     {9, "water", {0.25, 0.55, 0.85}},
     {10, "rail", {0.45, 0.25, 0.15}},
     {11, "road surface", {0.45, 0.45, 0.50}},
     {12, "overlap", {0.80, 0.80, 0.55}},
     {13, "wire, guard", {0.95, 0.65, 0.10}},
     {14, "wire, conductor", {0.90, 0.10, 0.12}},
     {15, "transmission tower", {0.35, 0.20, 0.60}},
     {16, "wire connector", {0.95, 0.45, 0.55}},
     {17, "bridge deck", {0.55, 0.55, 0.40}},
     {18, "high noise", {1.00, 0.40, 0.90}},
     {26, "crane", {0.10, 0.65, 0.70}}}};

/** \brief Distinct colors, repeated. */
Color
colorOfNumber(int number)
{
  static constexpr std::array<Color, 8> colors = {{{0.00, 0.45, 0.70},
                                                   {0.90, 0.62, 0.00},
                                                   {0.00, 0.62, 0.45},
                                                   {0.56, 0.37, 0.64},
                                                   {0.34, 0.71, 0.91},
                                                   {0.55, 0.43, 0.19},
                                                   {0.80, 0.20, 0.20},
                                                   {0.80, 0.47, 0.65}}};
  return colors[static_cast<std::size_t>(number - 1) % colors.size()];
}

Color
colorOfClass(int number)
{
  for (const ClassLook& look : class_looks)
    if (look.number == number)
      return look.color;
  return colorOfNumber(std::max(1, number));
}

} // namespace

Coloring
colorsByValue(const std::vector<float>& values, const std::string& title)
{
  constexpr std::size_t most = 200000; // values that determine the range
  std::vector<float> known;
  const std::size_t step = values.size() / most + 1;
  for (std::size_t i = 0; i < values.size(); i += step)
    if (std::isfinite(values[i]))
      known.push_back(values[i]);
  Legend legend;
  legend.title = title;
  legend.scale = true;
  const auto at = [&](double part) {
    const auto place =
        known.begin() +
        static_cast<std::ptrdiff_t>(part * static_cast<double>(known.size() - 1));
    std::nth_element(known.begin(), place, known.end());
    return static_cast<double>(*place);
  };
  if (!known.empty()) {
    legend.low = at(0.02);
    legend.high = at(0.98);
    if (legend.low == legend.high) {
      legend.low = at(0);
      legend.high = at(1);
    }
  }
  const double range = legend.high - legend.low;
  Coloring result = colored(values.size(), [&](std::size_t i) {
    if (!std::isfinite(values[i]))
      return unknown;
    return apps::scalarColor(
        range > 0 ? (static_cast<double>(values[i]) - legend.low) / range : 0.5);
  });
  result.legend = std::move(legend);
  return result;
}

Coloring
colorsByShape(const std::vector<float>& linearity,
              const std::vector<float>& planarity,
              const std::vector<float>& sphericity,
              const std::string& title)
{
  Coloring result = colored(linearity.size(), [&](std::size_t i) {
    if (std::isnan(linearity[i]))
      return unknown;
    return apps::shapeColor(apps::ShapeColors::Safe,
                            static_cast<double>(linearity[i]),
                            static_cast<double>(planarity[i]),
                            static_cast<double>(sphericity[i]));
  });
  result.legend.title = title;
  result.legend.shape = true;
  return result;
}

Coloring
colorsByClass(const std::vector<float>& classes, const std::string& title)
{
  std::set<int> seen;
  Coloring result = colored(classes.size(), [&](std::size_t i) {
    if (!std::isfinite(classes[i]))
      return unknown;
    const int number = static_cast<int>(classes[i]);
    seen.insert(number);
    return colorOfClass(number);
  });
  result.legend.title = title;
  for (const int number : seen)
    result.legend.entries.push_back({colorOfClass(number), className(number)});
  return result;
}

Coloring
colorsByNumber(const std::vector<float>& numbers, const std::string& title)
{
  Coloring result = colored(numbers.size(), [&](std::size_t i) {
    return numbers[i] >= 1 ? colorOfNumber(static_cast<int>(numbers[i])) : unknown;
  });
  result.legend.title = title;
  result.legend.entries = {{unknown, "none"}};
  return result;
}

Coloring
colorsAsGiven(const std::vector<float>& red,
              const std::vector<float>& green,
              const std::vector<float>& blue)
{
  float largest = 0;
  for (const auto* channel : {&red, &green, &blue})
    for (const float value : *channel)
      largest = std::max(largest, value);
  const double full = largest > 255 ? 65535 : 255;
  Coloring result = colored(red.size(), [&](std::size_t i) {
    return Color{std::clamp(static_cast<double>(red[i]) / full, 0.0, 1.0),
                 std::clamp(static_cast<double>(green[i]) / full, 0.0, 1.0),
                 std::clamp(static_cast<double>(blue[i]) / full, 0.0, 1.0)};
  });
  result.legend.title = "color of the file";
  return result;
}

std::string
className(int number)
{
  for (const ClassLook& look : class_looks)
    if (look.number == number)
      return std::to_string(number) + " " + look.name;
  return std::to_string(number);
}

} // namespace linelet::view
