// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/fittings/fittings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "powerline/fittings/find_sites.h"
#include "powerline/fittings/insulators.h"
#include "powerline/fittings/join_fittings.h"
#include "powerline/fittings/jumpers.h"

namespace linelet::powerline {

namespace {

/** Relabels the points of a site. */
class Labels {
public:
  Labels(PowerLineNetwork& network, const SupportSite& site)
      : network_(network), site_(site)
  {
  }

  bool
  isWire(Index i) const
  {
    return network_.wire_id[site_.input[i]] != 0;
  }

  void
  give(Index i, std::uint8_t number, const Wire* wire = nullptr)
  {
    const Index input = site_.input[i];
    if (network_.classes[input] == pylon_class && number != pylon_class)
      countPylonPoint(-1);
    else if (network_.classes[input] != pylon_class && number == pylon_class)
      countPylonPoint(1);
    network_.classes[input] = number;
    network_.wire_id[input] = wire != nullptr ? wire->id : 0;
    network_.span_id[input] = wire != nullptr ? wire->span : 0;
    network_.wire_distance[input] =
        wire != nullptr ? static_cast<float>(wire->curve.distance(site_.points[i]))
                        : std::numeric_limits<float>::quiet_NaN();
  }

private:
  void
  countPylonPoint(int change)
  {
    for (const int id : site_.supports) {
      Support& support = network_.supports[static_cast<std::size_t>(id) - 1];
      if (support.points == 0)
        continue;
      support.points =
          static_cast<std::size_t>(static_cast<long>(support.points) + change);
      return;
    }
  }

  PowerLineNetwork& network_;
  const SupportSite& site_;
};

// Wires keep the points that hang, and give the others to the structure. Where no
// string is seen, the fittings are small and stay as they are.
void
labelWires(const SupportSite& site,
           const std::vector<SeenString>& strings,
           const FittingPriors& priors,
           Labels& labels)
{
  std::vector<char> held(site.ends.size(), 0);
  for (const SeenString& seen : strings)
    if (seen.end >= 0)
      held[static_cast<std::size_t>(seen.end)] = 1;
  for (Index i = 0; i < site.points.size(); ++i) {
    if (site.tube[i] < 0)
      continue;
    const auto e = static_cast<std::size_t>(site.tube[i]);
    const WireEnd& end = site.ends[e];
    if (held[e] == 0 && std::abs(site.along[i]) < priors.link())
      continue;
    if (site.live[i] != 0 && !labels.isWire(i))
      labels.give(i, wire_class, end.wire);
    else if (site.earthed[i] != 0 && site.along[i] < end.earthed + priors.air_gap)
      labels.give(i, pylon_class);
  }
}

// What hangs from a wire beyond where a string may hold it is live: parts of a jumper
// that is not visible as a whole.
void
labelRests(const SupportSite& site,
           const std::vector<SeenJumper>& jumpers,
           const std::vector<SeenString>& strings,
           const FittingPriors& priors,
           Labels& labels)
{
  std::vector<char> known(site.points.size(), 0);
  for (const SeenJumper& seen : jumpers)
    for (const Index i : seen.points)
      known[i] = 1;
  for (const SeenString& seen : strings)
    for (const Index i : seen.points)
      known[i] = 1;
  const auto isRest = [&](Index i) { return site.isLoose(i) && known[i] == 0; };
  const auto hangs = [&](Index i) {
    bool found = false;
    site.grid->forEachWithin(site.points[i], priors.link(), [&](Index j, double) {
      if (site.tube[j] < 0 || site.live[j] == 0)
        return;
      const WireEnd& end = site.ends[static_cast<std::size_t>(site.tube[j])];
      found =
          found || site.along[j] >= std::max(end.earthed, 0.0) + priors.shortest_string;
    });
    return found;
  };
  for (const Indices& body : bodiesOf(site, priors.link(), isRest))
    if (std::any_of(body.begin(), body.end(), hangs))
      for (const Index i : body)
        labels.give(i, wire_class);
}

void
add(PowerLineNetwork& network,
    const std::vector<SeenJumper>& jumpers,
    const std::vector<SeenString>& strings,
    Labels& labels)
{
  const auto before = static_cast<int>(network.jumpers.size());
  for (const SeenJumper& seen : jumpers) {
    network.jumpers.push_back(seen.jumper);
    network.jumpers.back().id = static_cast<int>(network.jumpers.size());
    for (const Index i : seen.points)
      labels.give(i, wire_class);
  }
  for (const SeenString& seen : strings) {
    InsulatorString string = seen.string;
    string.id = static_cast<int>(network.insulators.size()) + 1;
    if (seen.jumper >= 0) {
      string.jumper = before + seen.jumper + 1;
      string.support = jumpers[static_cast<std::size_t>(seen.jumper)].jumper.support;
    }
    network.insulators.push_back(string);
    for (const Index i : seen.points)
      labels.give(i, connector_class);
  }
}

} // namespace

void
findFittings(PowerLineNetwork& network, const Candidates& candidates, unsigned threads)
{
  constexpr FittingPriors priors;
  for (SupportSite& site : findSites(network, candidates, priors, threads)) {
    const std::vector<SeenJumper> jumpers = findJumpers(site, priors);
    const std::vector<SeenString> strings = findInsulators(site, jumpers, priors);
    Labels labels(network, site);
    labelWires(site, strings, priors, labels);
    labelRests(site, jumpers, strings, priors, labels);
    add(network, jumpers, strings, labels);
  }
  numberFittings(network);
}

} // namespace linelet::powerline
