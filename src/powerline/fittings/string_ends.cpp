// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/fittings/string_ends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace linelet::powerline {

namespace {

// From the span toward the structure, as long as more points hang than are earthed.
void
findEarthedEnds(SupportSite& site, const FittingPriors& priors)
{
  const double step = priors.link(), few = 3;
  const double before = priors.longest_string;
  const auto bins = static_cast<std::size_t>(std::ceil(2 * before / step));
  std::vector<std::vector<double>> surplus(site.ends.size(),
                                           std::vector<double>(bins, 0));
  for (std::size_t i = 0; i < site.points.size(); ++i) {
    if (site.tube[i] < 0)
      continue;
    const double bin = (site.along[i] + before) / step;
    if (bin >= 0 && bin < static_cast<double>(bins))
      surplus[static_cast<std::size_t>(site.tube[i])][static_cast<std::size_t>(bin)] +=
          site.live[i] != 0 ? 1 : -1;
  }
  for (std::size_t e = 0; e < site.ends.size(); ++e) {
    std::size_t bin = bins;
    while (bin > 0 && surplus[e][bin - 1] > -few)
      --bin;
    while (bin < bins && surplus[e][bin] <= 0)
      ++bin;
    site.ends[e].earthed = static_cast<double>(bin) * step - before;
    // Where two wires meet, the structure is between them.
    const Point place = site.ends[e].at(0);
    for (std::size_t other = 0; other < site.ends.size(); ++other)
      if (other != e && (site.ends[other].at(0) - place).norm() < priors.half_width)
        site.ends[e].earthed = std::max(site.ends[e].earthed, 0.0);
  }
}

// Near a structure a string is no longer alone within the air gap, but still in its own
// tube: it continues as long as more is in the tube than around it.
void
followStrings(SupportSite& site, const FittingPriors& priors)
{
  const double step = priors.link() / 2;
  const auto bins = static_cast<std::size_t>(std::ceil(priors.air_gap / step));
  for (std::size_t e = 0; e < site.ends.size(); ++e) {
    WireEnd& end = site.ends[e];
    for (std::size_t bin = 0; bin < bins && end.earthed > step; ++bin) {
      const double from = end.earthed - step;
      Indices inside;
      std::size_t around = 0;
      site.grid->forEachWithin(
          end.at(from + step / 2), 3 * priors.half_width, [&](Index i, double) {
            const double along = end.along(site.points[i]);
            if (along < from || along >= end.earthed)
              return;
            const double d = end.wire->curve.distance(site.points[i]);
            if (d <= priors.half_width)
              inside.push_back(i);
            else if (d <= 2 * priors.half_width)
              ++around;
          });
      if (inside.empty() || around >= inside.size())
        break;
      for (const Index i : inside) {
        site.earthed[i] = 0;
        site.live[i] = 1;
      }
      end.earthed = from;
    }
  }
}

} // namespace

void
findStringEnds(SupportSite& site, const FittingPriors& priors)
{
  findEarthedEnds(site, priors);
  followStrings(site, priors);
}

} // namespace linelet::powerline
