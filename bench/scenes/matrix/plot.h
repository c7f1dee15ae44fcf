// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

#include <linelet/support/points.h>

namespace linelet::bench::scenes {

/** \brief A place with a direction: u along, v across, heights above its base. */
struct Plot {
  Point base, u, v;

  Plot(const Point& at, double direction)
      : base(at),
        u(std::cos(direction), std::sin(direction), 0),
        v(-std::sin(direction), std::cos(direction), 0)
  {
  }

  Point
  at(double along, double across, double height) const
  {
    return base + along * u + across * v + height * Point::UnitZ();
  }
};

} // namespace linelet::bench::scenes
