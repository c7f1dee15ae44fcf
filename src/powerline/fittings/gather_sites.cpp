// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/fittings/gather_sites.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "support/groups.h"

namespace linelet::powerline {

namespace {

// A string hangs more steeply than its wire, so their kink may have been taken for a
// support without points.
void
nameEnds(SupportSite& site, const PowerLineNetwork& network)
{
  for (std::size_t e = 0; e < site.ends.size(); ++e) {
    const WireEnd& end = site.ends[e];
    const int far = end.front ? end.wire->back_support : end.wire->front_support;
    const Point& place = end.front ? end.wire->back : end.wire->front;
    if (far == 0 || network.supports[static_cast<std::size_t>(far) - 1].points > 0 ||
        (place - site.axis).head<2>().norm() > site.radius)
      continue;
    for (const Wire& wire : network.wires)
      if (wire.id != end.wire->id && (wire.front == place || wire.back == place))
        site.end_of.emplace(wire.id, static_cast<int>(e));
  }
  for (std::size_t e = 0; e < site.ends.size(); ++e)
    site.end_of.emplace(site.ends[e].wire->id, static_cast<int>(e));
}

} // namespace

std::vector<SupportSite>
gatherSites(const PowerLineNetwork& network, const FittingPriors& priors)
{
  const std::size_t n = network.supports.size();
  std::vector<std::vector<WireEnd>> ends(n);
  for (const Wire& wire : network.wires)
    for (const bool front : {true, false})
      if (const int id = front ? wire.front_support : wire.back_support; id > 0)
        ends[static_cast<std::size_t>(id) - 1].push_back(
            {&wire, front, wire.curve.along(front ? wire.front : wire.back)});
  const auto axis = [&](std::size_t k) -> const Point& {
    return network.supports[k].base;
  };
  const double near = priors.longest_string + priors.longest_jumper;
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return axis(a).x() < axis(b).x();
  });
  Groups groups(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i + 1;
         k < n && axis(order[k]).x() <= axis(order[i]).x() + near;
         ++k)
      if ((axis(order[i]) - axis(order[k])).head<2>().norm() <= near)
        groups.unite(order[i], order[k]);
  std::vector<SupportSite> sites;
  std::vector<int> site_of(n, -1);
  std::vector<char> pylon;
  for (std::size_t k = 0; k < n; ++k) {
    int& place = site_of[groups.root(k)];
    if (place < 0) {
      place = static_cast<int>(sites.size());
      sites.emplace_back();
      pylon.push_back(0);
    }
    SupportSite& site = sites[static_cast<std::size_t>(place)];
    site.supports.push_back(network.supports[k].id);
    site.ends.insert(site.ends.end(), ends[k].begin(), ends[k].end());
    const Support& support = network.supports[k];
    if (support.kind == Support::Kind::Pylon && support.points > 0)
      pylon[static_cast<std::size_t>(place)] = 1;
  }
  std::vector<SupportSite> kept;
  for (std::size_t s = 0; s < sites.size(); ++s) {
    SupportSite& site = sites[s];
    if (pylon[s] == 0 || site.ends.empty())
      continue;
    for (const WireEnd& end : site.ends)
      site.axis += end.at(0) / static_cast<double>(site.ends.size());
    for (const WireEnd& end : site.ends)
      site.radius =
          std::max(site.radius, (end.at(0) - site.axis).head<2>().norm() + near);
    nameEnds(site, network);
    kept.push_back(std::move(site));
  }
  return kept;
}

} // namespace linelet::powerline
