// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/powerline/power_line_network.h>

#include "scene.h"

namespace linelet::view {

/** \brief A span from the side: meters along it and meters of height. */
struct SpanProfile {
  struct Place {
    double along, height;
  };
  struct Wire {
    int id = 0;
    double confidence = 1;
    std::vector<Place> curve;
    std::vector<Place> points; ///< that belong to it
  };
  struct Measure { ///< a clearance
    Place from, to;
    double distance = 0;
    bool to_ground = false;
    int wire = 0;
  };
  int span = 0;
  double length = 0;
  std::vector<Wire> wires;
  std::vector<Place> others; ///< points nearby that belong to no wire of the span
  std::vector<Place> ground; ///< terrain along the axis, empty where it is unknown
  std::vector<Measure> clearances;
};

/** \brief The profile of span number \a span of \a network.
 * \param[in] most number of points kept, evenly thinned */
SpanProfile
profileOf(const Scene& scene,
          const powerline::PowerLineNetwork& network,
          int span,
          std::size_t most = 8000);

} // namespace linelet::view
