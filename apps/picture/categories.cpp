// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "categories.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>

namespace linelet::apps {

namespace {

struct NamedClass {
  int number;
  const char* name;
  Color color;
};

// Names of LAS 1.4 (ASPRS), table 17.
const NamedClass classes[] = {{0, "never classified", {0.72, 0.72, 0.72}},
                              {1, "unclassified", {0.60, 0.60, 0.62}},
                              {2, "ground", {0.72, 0.58, 0.40}},
                              {3, "low vegetation", {0.70, 0.85, 0.45}},
                              {4, "medium vegetation", {0.42, 0.72, 0.30}},
                              {5, "high vegetation", {0.13, 0.50, 0.20}},
                              {6, "building", {0.80, 0.30, 0.25}},
                              {7, "low noise", {0.85, 0.10, 0.75}},
                              {8, "model key", {0.45, 0.35, 0.25}},
                              {9, "water", {0.25, 0.55, 0.90}},
                              {10, "rail", {0.35, 0.30, 0.45}},
                              {11, "road", {0.40, 0.40, 0.42}},
                              {13, "wire guard", {0.95, 0.75, 0.10}},
                              {14, "wire conductor", {0.95, 0.50, 0.00}},
                              {15, "transmission tower", {0.15, 0.20, 0.55}},
                              {16, "wire connector", {0.55, 0.25, 0.75}},
                              {17, "bridge deck", {0.55, 0.75, 0.80}},
                              {18, "high noise", {1.00, 0.00, 0.50}}};

constexpr Color none = {0.78, 0.78, 0.80};

Color
fromHue(double hue, double value)
{
  Color color;
  for (std::size_t c = 0; c < 3; ++c) {
    const double at = std::fmod(hue * 6 + 5 - 2 * static_cast<double>(c) + 6, 6.0);
    color[c] = value * (1 - 0.75 * std::clamp(std::min(at, 4 - at), 0.0, 1.0));
  }
  return color;
}

/** Golden-ratio steps keep successive hues apart. */
Color
colorOf(std::int64_t value)
{
  if (value == 0)
    return none;
  constexpr double golden = 0.61803398874989485;
  const double turns = golden * static_cast<double>(value);
  return fromHue(turns - std::floor(turns), value % 2 == 0 ? 0.75 : 0.92);
}

} // namespace

bool
isCategorical(const io::Column& column)
{
  static constexpr std::string_view named[] = {"classification",
                                               "return_number",
                                               "number_of_returns",
                                               "point_source_id",
                                               "scanner_channel",
                                               "synthetic",
                                               "key_point",
                                               "withheld",
                                               "overlap",
                                               "scan_direction",
                                               "edge_of_flight_line"};
  const std::string_view name = column.name;
  const bool real = std::holds_alternative<std::vector<float>>(column.values) ||
                    std::holds_alternative<std::vector<double>>(column.values);
  const bool id = name.size() > 3 && name.substr(name.size() - 3) == "_id";
  return std::find(std::begin(named), std::end(named), name) != std::end(named) ||
         (id && !real);
}

Categories
categoriesOf(const io::Column& column)
{
  Categories result;
  std::map<std::int64_t, std::size_t> counts;
  const bool by_class = column.name == "classification";
  std::map<std::int64_t, Color> colors;
  const std::size_t n = io::size(column.values);
  for (std::size_t i = 0; i < n; ++i) {
    const double real = io::valueAt(column, i);
    const auto value = std::isfinite(real) ? static_cast<std::int64_t>(real) : 0;
    ++counts[value];
    const auto [at, fresh] = colors.emplace(value, none);
    if (fresh) {
      at->second = colorOf(value + (by_class ? 7 : 0)); // user-defined classes
      if (by_class)
        for (const NamedClass& known : classes)
          if (known.number == value)
            at->second = known.color;
    }
    result.colors.push_back(at->second);
  }
  std::vector<std::pair<std::int64_t, std::size_t>> order(counts.begin(), counts.end());
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return a.second > b.second;
  });
  for (const auto& [value, count] : order) {
    std::string name = std::to_string(value);
    if (by_class)
      for (const NamedClass& known : classes)
        if (known.number == value)
          name += std::string(" ") + known.name;
    if (!by_class && value == 0 && column.name.find("_id") != std::string::npos)
      name = "none";
    result.legend.emplace_back(colors[value], name);
  }
  return result;
}

} // namespace linelet::apps
