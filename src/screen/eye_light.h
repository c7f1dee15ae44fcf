// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>

#include <linelet/support/points.h>

namespace linelet::screen {

/** \brief Shading of an opaque surface by a light over the viewer's left shoulder.
 * \param[in] normal components to the right, down, away; turned toward the eye
 * \return color and alpha */
inline std::array<float, 4>
lit(const std::array<float, 3>& color, const Point& normal)
{
  static const Point light = Point(-0.4, -0.6, -0.7).normalized();
  constexpr double ambient = 0.35;
  const auto shade =
      static_cast<float>(ambient + (1 - ambient) * std::max(0.0, normal.dot(light)));
  return {color[0] * shade, color[1] * shade, color[2] * shade, 1};
}

} // namespace linelet::screen
