// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include <linelet/support/names.h>

namespace linelet::apps {

/** \brief Red, green, blue in [0, 1]. */
using Color = std::array<double, 3>;

/** \brief Which colors stand for linearity, planarity and sphericity. */
enum class ShapeColors {
  Classic, ///< light gray, blue, green
  Safe ///< pale yellow, blue, dark red: distinct for color-blind readers and in gray
};

/** \brief The same for tensor splats, which fade on paper. */
enum class SplatColors {
  Safe,   ///< blue, orange, gray: distinct for color-blind readers
  Classic ///< green, red, blue, as published
};

inline Color
mix(const Color& a, const Color& b, double part_of_b)
{
  Color result{};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = a[i] + (b[i] - a[i]) * part_of_b;
  return result;
}

/** \brief The pure colors of linearity, planarity and sphericity. */
inline std::array<Color, 3>
shapeColors(ShapeColors colors)
{
  if (colors == ShapeColors::Classic)
    return {{{0.84, 0.84, 0.84}, {0.13, 0.33, 0.85}, {0.10, 0.62, 0.20}}};
  return {{{0.99, 0.91, 0.60}, {0.16, 0.47, 0.84}, {0.55, 0.06, 0.10}}};
}

inline std::array<Color, 3>
splatColors(SplatColors colors)
{
  if (colors == SplatColors::Classic)
    return {{{0, 0.75, 0}, {0.9, 0, 0}, {0, 0, 1}}};
  return {{{0.00, 0.30, 0.65}, {0.90, 0.55, 0.00}, {0.60, 0.60, 0.60}}};
}

/** \brief CL * first + CP * second + CS * third color. */
inline Color
shapeColor(ShapeColors colors, double linearity, double planarity, double sphericity)
{
  const std::array<Color, 3> pure = shapeColors(colors);
  Color result{};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = std::clamp(linearity * pure[0][i] + planarity * pure[1][i] +
                               sphericity * pure[2][i],
                           0.0,
                           1.0);
  return result;
}

/** \brief A scalar in [0, 1] from dark violet through green to yellow, with rising
 * lightness, so that it reads in gray and for the color-blind. */
inline Color
scalarColor(double t)
{
  constexpr std::array<Color, 6> stops = {{{0.27, 0.00, 0.33},
                                           {0.25, 0.27, 0.53},
                                           {0.16, 0.47, 0.56},
                                           {0.13, 0.66, 0.52},
                                           {0.48, 0.82, 0.32},
                                           {0.99, 0.91, 0.14}}};
  const double place = std::clamp(t, 0.0, 1.0) * (stops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return mix(stops[low], stops[low + 1], place - static_cast<double>(low));
}

namespace ink {
constexpr Color paper = {1, 1, 1};
constexpr Color text = {0.13, 0.13, 0.15};
constexpr Color frame = {0.35, 0.35, 0.38};
constexpr Color grid = {0.88, 0.88, 0.90};
constexpr Color unknown = {1, 1, 1};
constexpr Color mark = {0.80, 0.15, 0.10};
} // namespace ink

} // namespace linelet::apps

namespace linelet {

template <>
struct Names<apps::ShapeColors> {
  static constexpr std::string_view kind = "colors";
  static constexpr std::array<std::pair<apps::ShapeColors, std::string_view>, 2> table =
      {{{apps::ShapeColors::Classic, "classic"}, {apps::ShapeColors::Safe, "safe"}}};
};

template <>
struct Names<apps::SplatColors> {
  static constexpr std::string_view kind = "colors of splats";
  static constexpr std::array<std::pair<apps::SplatColors, std::string_view>, 2> table =
      {{{apps::SplatColors::Safe, "safe"}, {apps::SplatColors::Classic, "classic"}}};
};

} // namespace linelet
