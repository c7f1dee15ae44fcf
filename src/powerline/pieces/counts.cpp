// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/counts.h"

#include <algorithm>
#include <cmath>

namespace linelet::powerline {

double
logWire(const Counts& c, double density)
{
  constexpr double vague = 0.5; // shape of Jeffreys' prior of a rate
  constexpr double large = 1e200, log_large = 460.51701859880916;
  // Sum over the points that are the wire's own, each term from the one before.
  double term = 1, sum = 1, scale = -density;
  for (double own = 1; own <= c.tube; ++own) {
    const double others = c.tube - own;
    term *= density / own * (others + 1) * (c.larger + 1) / (others + c.around + vague);
    sum += term;
    if (sum > large) {
      sum /= large;
      term /= large;
      scale += log_large;
    }
  }
  return std::log(sum) + scale;
}

double
logWire(const Counts& counts, double density, double hidden)
{
  constexpr double largest = 500; // of an exponent, within the range of a double
  const double seen = std::min(largest, logWire(counts, density));
  return std::log((1 - hidden) * std::exp(seen) + hidden);
}

} // namespace linelet::powerline
