// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/fittings/wire_tubes.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace linelet::powerline {

void
layTubes(SupportSite& site,
         const PowerLineNetwork& network,
         const FittingPriors& priors)
{
  const double step = 0.5, reach = priors.half_width + priors.link() / 2;
  // Where two wires meet, a place belongs to the wire that does not end before it.
  const double beyond = 0.1;
  std::vector<double> best(site.points.size(), reach);
  site.tube.assign(site.points.size(), SupportSite::none);
  site.along.assign(site.points.size(), 0);
  for (std::size_t e = 0; e < site.ends.size(); ++e) {
    const WireEnd& end = site.ends[e];
    const double last = std::min(end.wire->span_length, 2 * site.radius);
    for (double u = -priors.longest_string; u <= last; u += step)
      site.grid->forEachWithin(
          end.at(u), std::hypot(step, reach), [&](Index i, double) {
            const double along = end.along(site.points[i]);
            const double d = end.wire->curve.distance(site.points[i]) +
                             beyond * std::max(0.0, -along);
            if (d >= best[i])
              return;
            best[i] = d;
            site.tube[i] = static_cast<int>(e);
            site.along[i] = along;
          });
  }
  for (std::size_t i = 0; i < site.points.size(); ++i) {
    const int wire = network.wire_id[site.input[i]];
    if (wire == 0 || site.tube[i] != SupportSite::none)
      continue;
    const auto found = site.end_of.find(wire);
    if (found == site.end_of.end()) {
      site.tube[i] = SupportSite::other_wire;
      continue;
    }
    site.tube[i] = found->second;
    site.along[i] =
        site.ends[static_cast<std::size_t>(found->second)].along(site.points[i]);
  }
}

} // namespace linelet::powerline
