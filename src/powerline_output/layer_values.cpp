// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "layer_values.h"

#include <cmath>
#include <cstdint>
#include <cstdio>

namespace linelet::powerline {

io::Value
whole(std::size_t value)
{
  return static_cast<std::int64_t>(value);
}

io::Value
whole(int value)
{
  return static_cast<std::int64_t>(value);
}

std::string
decimals(double value)
{
  if (!std::isfinite(value))
    return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

Points
worldPoints(const Points& points, const MetricFrame& frame)
{
  Points world;
  for (const Point& p : points)
    world.push_back(frame.world(p));
  return world;
}

void
setTextHeight(std::vector<io::VectorLayer>& layers, const MetricFrame& frame)
{
  constexpr double height = 0.5; // meters
  for (io::VectorLayer& layer : layers)
    layer.text_height = height / frame.units().plan;
}

} // namespace linelet::powerline
