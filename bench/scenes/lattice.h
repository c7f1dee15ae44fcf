// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>

namespace linelet::bench {

/** \brief Calls bar(from, to, share of the radius) for every bar of a lattice of
 * \a bays between two squares (four corners each): legs, diagonals and horizontals. */
template <class Bar>
void
forEachLatticeBar(const Point (&bottom)[4], const Point (&top)[4], int bays, Bar&& bar)
{
  const auto corner = [&](int leg, int level) -> Point {
    const double t = static_cast<double>(level) / bays;
    return bottom[leg] + t * (top[leg] - bottom[leg]);
  };
  for (int level = 0; level < bays; ++level)
    for (int leg = 0; leg < 4; ++leg) {
      const int next = (leg + 1) % 4;
      bar(corner(leg, level), corner(leg, level + 1), 1.0);
      bar(corner(leg, level), corner(next, level + 1), 0.5);
      bar(corner(next, level), corner(leg, level + 1), 0.5);
      bar(corner(leg, level + 1), corner(next, level + 1), 0.6);
    }
}

} // namespace linelet::bench
