// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/tube_radius.h"

#include <algorithm>
#include <cmath>

namespace linelet::powerline {

double
tubeRadius(std::vector<double> distances)
{
  constexpr double widest = widest_tube_seen;
  std::sort(distances.begin(), distances.end());
  const double half = widest / std::sqrt(2.0);
  const auto outside = static_cast<double>(
      distances.end() - std::lower_bound(distances.begin(), distances.end(), half));
  const double background = 2 * outside / (widest * widest); // per squared distance
  const double all =
      static_cast<double>(distances.size()) - background * widest * widest;
  for (std::size_t i = 0; i < distances.size(); ++i)
    if (static_cast<double>(i + 1) - background * distances[i] * distances[i] >=
        tube_part * all)
      return distances[i];
  return widest;
}

} // namespace linelet::powerline
