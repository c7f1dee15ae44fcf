// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/fittings/support_site.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <linelet/support/threads.h>
#include <linelet/tensor/eigen_analysis.h>
#include <linelet/tensor/neighborhood_tensor.h>

#include "support/groups.h"
#include "support/parallel_failure.h"

namespace linelet::powerline {

namespace {

constexpr std::size_t fewest = 5; // points of a body, and of a shape

// Gathers the ends of wires at supports, and supports whose surroundings overlap.
std::vector<SupportSite>
gather(const PowerLineNetwork& network, const FittingPriors& priors)
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
    kept.push_back(std::move(site));
  }
  return kept;
}

// A string hangs steeper than its wire: their kink may have been taken for a support of
// which nothing is seen.
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

// Whether points of its wires follow each other so closely that bodies hang together.
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
  // Gaps of Poisson points exceed the link with exp(-density * link).
  return *middle * priors.link() >= -std::log(priors.unseen);
}

void
collect(SupportSite& site, const Candidates& candidates, const FittingPriors& priors)
{
  // As far down as a string and a jumper may hang from the lowest wire, and the pylon's
  // body that tells what is earthed.
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

// Gives every point near a wire to the nearest end.
void
layTubes(SupportSite& site,
         const PowerLineNetwork& network,
         const FittingPriors& priors)
{
  const double step = 0.5, reach = priors.half_width + priors.link() / 2;
  // Where two wires meet, the place belongs to that which does not end before it.
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

// The direction of every point whose surroundings are thin; else 0.
Points
findThin(const SupportSite& site, const FittingPriors& priors, unsigned threads)
{
  Points thin(site.points.size(), Point::Zero());
  const auto count = static_cast<std::ptrdiff_t>(site.points.size());
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic, 256) num_threads(threadCount(threads))
  for (std::ptrdiff_t k = 0; k < count; ++k)
    failure.guard([&] {
      Points near;
      Point sum = Point::Zero();
      const auto i = static_cast<std::size_t>(k);
      site.grid->forEachOffsetWithin(
          site.points[i], priors.air_gap, [&](const Point& offset, double) {
            near.push_back(offset);
            sum += offset;
          });
      if (near.size() < fewest)
        return;
      const EigenSystem axes = eigenAnalysis(neighborhoodTensor(
          near, sum / static_cast<double>(near.size()), priors.air_gap, Kernel::Const));
      const double ratio = std::sqrt(axes.values[1] / axes.values[2]);
      if (ratio <= priors.thin())
        thin[i] = axes.major();
    });
  failure.rethrow();
  return thin;
}

// Whether a thin point in the tube of a wire is the tip of an arm or a peak that the
// wire, or its string, is fixed to: it runs across the wire, and not up from it.
bool
isTip(const SupportSite& site, Index i, const Point& direction, double reach)
{
  constexpr double across = 0.7; // cosine of 45 degrees
  if (site.tube[i] < 0 || site.along[i] > reach)
    return false;
  const WireEnd& end = site.ends[static_cast<std::size_t>(site.tube[i])];
  const Point place = end.at(site.along[i]);
  const Point course = (end.at(site.along[i] + 1) - place).normalized();
  return std::abs(direction.dot(course)) < across && site.points[i].z() <= place.z();
}

void
tellApart(SupportSite& site, const FittingPriors& priors, unsigned threads)
{
  site.direction = findThin(site, priors, threads);
  const Points& thin = site.direction;
  site.earthed.assign(site.points.size(), 0);
  const auto isBulky = [&](Index i) {
    return thin[i].isZero() || isTip(site, i, thin[i], priors.air_gap);
  };
  for (const Indices& body : bodiesOf(site, priors.link(), isBulky)) {
    Point low = site.points[body.front()], high = low;
    for (const Index i : body) {
      low = low.cwiseMin(site.points[i]);
      high = high.cwiseMax(site.points[i]);
    }
    if ((high - low).maxCoeff() > priors.bulky)
      for (const Index i : body)
        site.earthed[i] = 1;
  }
  site.live.assign(site.points.size(), 0);
  for (const Indices& body :
       bodiesOf(site, priors.link(), [&](Index i) { return site.earthed[i] == 0; })) {
    const auto of_wires =
        static_cast<std::size_t>(std::count_if(body.begin(), body.end(), [&](Index i) {
          return site.tube[i] >= 0 && site.along[i] > priors.air_gap;
        }));
    if (of_wires >= fewest)
      for (const Index i : body)
        site.live[i] = 1;
  }
}

// From the span towards the structure, as far as more hangs there than is earthed.
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
    // Where two wires meet there is the structure between them.
    const Point place = site.ends[e].at(0);
    for (std::size_t other = 0; other < site.ends.size(); ++other)
      if (other != e && (site.ends[other].at(0) - place).norm() < priors.half_width)
        site.ends[e].earthed = std::max(site.ends[e].earthed, 0.0);
  }
}

// Near a structure a string is not alone within the gap any more, but still in its own
// tube: it goes on as long as less is around that than in it.
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

Point
WireEnd::outward() const
{
  Point out = at(1) - at(0);
  out.z() = 0;
  return out.normalized();
}

std::vector<SupportSite>
findSites(const PowerLineNetwork& network,
          const Candidates& candidates,
          const FittingPriors& priors,
          unsigned threads)
{
  std::vector<SupportSite> sites;
  for (SupportSite& site : gather(network, priors)) {
    nameEnds(site, network);
    collect(site, candidates, priors);
    if (!isDense(site, network, priors))
      continue;
    layTubes(site, network, priors);
    tellApart(site, priors, threads);
    findEarthedEnds(site, priors);
    followStrings(site, priors);
    sites.push_back(std::move(site));
  }
  return sites;
}

} // namespace linelet::powerline
