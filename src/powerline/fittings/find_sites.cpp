// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/fittings/find_sites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "powerline/fittings/gather_sites.h"
#include "powerline/fittings/live_parts.h"
#include "powerline/fittings/string_ends.h"
#include "powerline/fittings/wire_tubes.h"

namespace linelet::powerline {

namespace {

// Whether points on its wires are dense enough for bodies to be connected.
bool
isDense(const SupportSite& site,
        const PowerLineNetwork& network,
        const FittingPriors& priors)
{
  std::map<int, double> counts;
  for (const Index i : site.input)
    ++counts[network.wire_id[i]];
  std::vector<double> densities;
  for (const WireEnd& end : site.ends) {
    const double count = counts[end.wire->id];
    const double length = std::min(
        end.wire->span_length, site.radius - (end.at(0) - site.axis).head<2>().norm());
    if (length > 0)
      densities.push_back(count / length);
  }
  if (densities.empty())
    return false;
  const auto middle =
      densities.begin() + static_cast<std::ptrdiff_t>(densities.size() / 2);
  std::nth_element(densities.begin(), middle, densities.end());
  // Gaps of Poisson points exceed the link with probability exp(-density * link).
  return *middle * priors.link() >= -std::log(priors.unseen);
}

void
collect(SupportSite& site, const Candidates& candidates, const FittingPriors& priors)
{
  // Down to where a string and a jumper may hang below the lowest wire, and to the
  // pylon's body, which shows what is earthed.
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const WireEnd& end : site.ends) {
    low = std::min(low, end.at(0).z());
    high = std::max(high, end.at(0).z());
  }
  low -= priors.longest_string + priors.bulky;
  high += priors.longest_string;
  Point middle = site.axis;
  middle.z() = (low + high) / 2;
  candidates.grid.forEachWithin(
      middle, std::hypot(site.radius, (high - low) / 2), [&](Index i, double) {
        const Point& p = candidates.points[i];
        if (p.z() < low || p.z() > high ||
            (p - site.axis).head<2>().norm() > site.radius)
          return;
        site.points.push_back(p);
        site.input.push_back(candidates.input[i]);
      });
  site.grid = std::make_unique<UniformGrid>(site.points, priors.air_gap / 2);
}

} // namespace

std::vector<SupportSite>
findSites(const PowerLineNetwork& network,
          const Candidates& candidates,
          const FittingPriors& priors,
          unsigned threads)
{
  std::vector<SupportSite> sites;
  for (SupportSite& site : gatherSites(network, priors)) {
    collect(site, candidates, priors);
    if (!isDense(site, network, priors))
      continue;
    layTubes(site, network, priors);
    findLiveParts(site, priors, threads);
    findStringEnds(site, priors);
    sites.push_back(std::move(site));
  }
  return sites;
}

} // namespace linelet::powerline
