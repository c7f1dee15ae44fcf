// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <QColor>

#include "picture/color.h"

namespace linelet::view {

/** Colors of lines and text in charts
 * @{ */
inline const QColor linear_color(110, 114, 120), planar_color(33, 84, 217),
    spherical_color(26, 158, 51), yellow(222, 165, 0), red(205, 30, 30),
    dark(40, 44, 50);
/** @} */

inline QColor
faded(QColor color, int alpha)
{
  color.setAlpha(alpha);
  return color;
}

inline QColor
colorOf(const apps::Color& c)
{
  return QColor::fromRgbF(c[0], c[1], c[2]);
}

} // namespace linelet::view
