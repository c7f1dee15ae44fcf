// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/open_below.h"

#include <cmath>

#include "powerline/line_priors.h"

namespace linelet::powerline {

namespace {

constexpr double deep = 1.5; // meters below a wire
constexpr double beside =
    1.25; // meters to both sides; twice that where nothing is seen
constexpr double roof_rise = 3;      // meters: of a roof of 45 degrees, as far as that
constexpr double itself_reach = 0.5; // meters of height, of its own points

} // namespace

double
openBelow(const SpanModel& m, const Underside& underside)
{
  double open = 0, all = 0;
  for (double s = m.begin; s <= m.end; s += 1) {
    const Point p = m.at(s);
    const auto lowestBeside = [&](double to_left) {
      return static_cast<double>(underside.lowestAt(p.x() - to_left * m.direction.y(),
                                                    p.y() + to_left * m.direction.x()));
    };
    const double below = lowestBeside(0);
    bool blocked = std::abs(below - p.z()) >= itself_reach && below > p.z() - deep;
    for (const double side : {-1, 1}) {
      double lowest = lowestBeside(side * beside);
      if (std::isnan(lowest))
        lowest = lowestBeside(side * 2 * beside);
      // Over water, the lowest point beside a wire may be on a wire of the arm above.
      blocked = blocked || (lowest > p.z() - deep && lowest <= p.z() + roof_rise);
    }
    open += !blocked;
    all += 1;
  }
  return open / all;
}

bool
isOpenBelow(const SpanModel& m, const Underside& underside)
{
  return openBelow(m, underside) >= LinePriors().open_itself;
}

} // namespace linelet::powerline
