// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/fittings/jumpers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "powerline/fittings/curve_through.h"

namespace linelet::powerline {

namespace {

constexpr double turned = 0.5; // largest cosine between wires that a jumper connects
constexpr double unreached = std::numeric_limits<double>::infinity();

/** A loose point beside a wire, where a jumper may be clamped. */
struct Contact {
  Index point;
  double along;
};

/** A path between two ends. */
struct Way {
  double cost = unreached;
  std::size_t from = 0, to = 0;
  double from_clamp = 0, to_clamp = 0;
  Indices points;
};

/** Walks from loose point to loose point. */
class Walk {
public:
  Walk(const SupportSite& site, const FittingPriors& priors)
      : site_(site),
        priors_(priors),
        contacts_(site.ends.size()),
        taken_(site.points.size(), 0)
  {
    for (Index i = 0; i < site.points.size(); ++i)
      if (site.isLoose(i))
        touch(i);
  }

  /** The shortest path from point to nearby point that is not a jumper yet. */
  bool
  next(Way& best, const std::vector<WireEnd>& ends) const
  {
    best.cost = unreached;
    for (std::size_t e = 0; e < ends.size(); ++e)
      if (!ends[e].clamped && !contacts_[e].empty())
        walkFrom(e, ends, best);
    return best.cost < unreached;
  }

  void
  take(const Indices& points)
  {
    for (const Index i : points)
      taken_[i] = 1;
  }

private:
  // Beyond the shortest string, as seen from the structure and from the place where the
  // wire is fixed, and not beyond the longest.
  void
  touch(Index i)
  {
    std::vector<double> nearest(contacts_.size(), unreached),
        along(contacts_.size(), 0);
    site_.grid->forEachWithin(
        site_.points[i], priors_.link(), [&](Index j, double squared) {
          if (site_.tube[j] < 0 || site_.live[j] == 0)
            return;
          const auto e = static_cast<std::size_t>(site_.tube[j]);
          if (squared < nearest[e]) {
            nearest[e] = squared;
            along[e] = site_.along[j];
          }
        });
    for (std::size_t e = 0; e < contacts_.size(); ++e) {
      const double string = along[e] - site_.ends[e].earthed;
      if (nearest[e] < unreached &&
          std::min(string, along[e]) >= priors_.shortest_string &&
          string <= priors_.longest_string)
        contacts_[e].push_back({i, along[e]});
    }
  }

  void
  walkFrom(std::size_t from, const std::vector<WireEnd>& ends, Way& best) const
  {
    // Squares of the steps, so that a path stays where points are dense.
    std::vector<double> cost(site_.points.size(), unreached);
    std::vector<Index> before(site_.points.size());
    using Open = std::pair<double, Index>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    for (const Contact& c : contacts_[from])
      if (taken_[c.point] == 0) {
        cost[c.point] = 0;
        before[c.point] = c.point;
        open.emplace(0, c.point);
      }
    while (!open.empty()) {
      const auto [so_far, i] = open.top();
      open.pop();
      if (so_far > cost[i] || so_far >= best.cost)
        continue;
      site_.grid->forEachWithin(
          site_.points[i], priors_.stride(), [&, here = i](Index j, double squared) {
            if (!site_.isLoose(j) || taken_[j] != 0 || cost[here] + squared >= cost[j])
              return;
            cost[j] = cost[here] + squared;
            before[j] = here;
            open.emplace(cost[j], j);
          });
    }
    for (std::size_t to = 0; to < ends.size(); ++to) {
      if (to == from || ends[to].clamped ||
          ends[from].outward().dot(ends[to].outward()) > turned)
        continue;
      for (const Contact& c : contacts_[to])
        if (cost[c.point] < best.cost)
          consider(from, to, c, cost, before, best);
    }
  }

  // Whether most thin parts along a path run along it: between wires that are fixed to
  // a peak, a path leads across the peak.
  bool
  isFollowed(const Indices& way) const
  {
    constexpr double aligned = 0.7; // cosine of 45 degrees
    const std::size_t span = 2;     // steps that give the direction of the way
    std::size_t along = 0, thin = 0;
    for (std::size_t k = 0; k < way.size(); ++k) {
      const Point& direction = site_.direction[way[k]];
      const Point course = site_.points[way[std::min(k + span, way.size() - 1)]] -
                           site_.points[way[k < span ? 0 : k - span]];
      if (direction.isZero() || course.isZero())
        continue;
      ++thin;
      along += std::abs(direction.dot(course.normalized())) >= aligned ? 1 : 0;
    }
    return 2 * along >= thin;
  }

  void
  consider(std::size_t from,
           std::size_t to,
           const Contact& contact,
           const std::vector<double>& cost,
           const std::vector<Index>& before,
           Way& best) const
  {
    Indices way = {contact.point};
    double length = 0;
    while (before[way.back()] != way.back()) {
      const Index i = way.back();
      way.push_back(before[i]);
      length += (site_.points[i] - site_.points[way.back()]).norm();
    }
    const double chord = (site_.points[way.front()] - site_.points[way.back()]).norm();
    if (chord < 2 * priors_.shortest_string ||
        length > priors_.longest_jumper * chord || !isFollowed(way))
      return;
    const auto clamp = [&](std::size_t e, Index i) {
      for (const Contact& c : contacts_[e])
        if (c.point == i)
          return c.along;
      return 0.0;
    };
    best.cost = cost[contact.point];
    best.from = from;
    best.to = to;
    best.from_clamp = clamp(from, way.back());
    best.to_clamp = contact.along;
    std::reverse(way.begin(), way.end());
    best.points = std::move(way);
  }

  const SupportSite& site_;
  const FittingPriors& priors_;
  std::vector<std::vector<Contact>> contacts_; ///< of each end
  std::vector<char> taken_;
};

// The loose points within a bundle's reach of a path.
Indices
pointsBeside(const SupportSite& site, const Indices& way, double reach)
{
  std::vector<char> seen(site.points.size(), 0);
  Indices beside;
  for (const Index w : way)
    site.grid->forEachWithin(site.points[w], reach, [&](Index i, double) {
      if (seen[i] != 0 || !site.isLoose(i))
        return;
      seen[i] = 1;
      beside.push_back(i);
    });
  std::sort(beside.begin(), beside.end());
  return beside;
}

// The other wires of a bundle end at the same yoke.
void
clampBeside(SupportSite& site, std::size_t clamped, const FittingPriors& priors)
{
  const Point clamp = site.ends[clamped].at(site.ends[clamped].clamp);
  const Point outward = site.ends[clamped].outward();
  for (WireEnd& end : site.ends) {
    if (end.clamped || end.outward().dot(outward) <= turned)
      continue;
    const double along = end.along(clamp);
    if ((end.at(along) - clamp).norm() > 2 * priors.half_width + priors.link())
      continue;
    end.clamp = along;
    end.clamped = true;
  }
}

void
describe(SeenJumper& seen, const SupportSite& site, const Way& way)
{
  const WireEnd &from = site.ends[way.from], &to = site.ends[way.to];
  Jumper& jumper = seen.jumper;
  const auto support = [](const WireEnd& end) {
    return end.front ? end.wire->front_support : end.wire->back_support;
  };
  jumper.support = support(from);
  jumper.from_wire = from.wire->id;
  jumper.to_wire = to.wire->id;
  jumper.points = seen.points.size();
  jumper.course.insert(jumper.course.begin(), from.at(way.from_clamp));
  jumper.course.push_back(to.at(way.to_clamp));
  const Points& course = jumper.course;
  for (std::size_t v = 1; v < course.size(); ++v)
    jumper.length += (course[v] - course[v - 1]).norm();
  const Point chord = course.back() - course.front();
  double squares = 0;
  for (const Point& p : course) {
    const double part = (p - course.front()).dot(chord) / chord.squaredNorm();
    jumper.sag = std::max(jumper.sag, course.front().z() + part * chord.z() - p.z());
  }
  for (const Index i : seen.points)
    squares += std::pow(distanceTo(course, site.points[i]), 2);
  jumper.rms = std::sqrt(squares / static_cast<double>(seen.points.size()));
}

} // namespace

std::vector<SeenJumper>
findJumpers(SupportSite& site, const FittingPriors& priors)
{
  std::vector<SeenJumper> jumpers;
  Walk walk(site, priors);
  for (Way way; walk.next(way, site.ends);) {
    SeenJumper seen;
    seen.points = pointsBeside(site, way.points, 2 * priors.half_width);
    walk.take(seen.points);
    Points vertices, members;
    for (const Index i : way.points)
      vertices.push_back(site.points[i]);
    for (const Index i : seen.points)
      members.push_back(site.points[i]);
    seen.jumper.course = curveThrough(vertices, members, 2 * priors.half_width);
    for (const auto& [e, clamp] :
         {std::pair(way.from, way.from_clamp), std::pair(way.to, way.to_clamp)}) {
      site.ends[e].clamp = clamp;
      site.ends[e].clamped = true;
    }
    clampBeside(site, way.from, priors);
    clampBeside(site, way.to, priors);
    describe(seen, site, way);
    jumpers.push_back(std::move(seen));
  }
  return jumpers;
}

} // namespace linelet::powerline
