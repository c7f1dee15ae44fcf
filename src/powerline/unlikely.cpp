// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <utility>

#include "powerline/evidence.h"
#include "powerline/false_positives.h"
#include "powerline/groups.h"
#include "powerline/joints.h"

namespace linelet::powerline {

namespace {

constexpr double company_reach = 14;  // meters between the wires of a line
constexpr double company_part = 0.35; // of the length of the longer
constexpr double steep = 0.12;        // slope between the ends
constexpr double least_bend = 1e-4;   // z2 of a wire, 1/meters: a = 5 km
constexpr double clear_bend = 2e-4;   // of a line so short that it hangs from poles
constexpr double long_line = 60;      // meters, from which a line speaks for itself
constexpr double short_line = 25;     // meters, the least inside the data
constexpr std::size_t many = 4;       // wires of a family that prove each other
constexpr double clean_part = 0.75;   // of the length of short wires at the border

constexpr double lone_length = 18;    // meters of a lone wire in the clear
constexpr double lone_clean = 0.8;    // of its bins
constexpr double telling_length = 20; // meters of a wire whose sag says something
constexpr double stray_length = 40;   // meters of a thinly covered wire that meets none
constexpr double lone_cover = 0.5;    // of the bins of a line inside the data
constexpr double lone_open = 0.8;     // of its length, with nothing but deep below
constexpr double deep = 1.5;          // meters below a wire
constexpr double beside = 1.25;       // meters, looked at on both sides

constexpr double least_hanging = 3;  // meters between attachment points
constexpr double hanging_part = 0.5; // of the stretch with points, the same
constexpr double farthest_off = 1.5; // meters of an attachment point from the wire

/** Wires that run side by side or go on as one another: they speak for each other. */
struct Family {
  std::size_t wires = 0;
  double longest = 0;              ///< longest chain of joined wires, meters
  double single = 0;               ///< longest wire, meters
  double bend = 0, weight = 0;     ///< sums over the wires, weighted by length
  double bends = 0, precision = 0; ///< of the points alone, weighted by precision
  double clean = 0, occupied = 0, bins = 0; ///< sums of the evidence of short chains
  bool border = false;                      ///< a wire leaves the data
  bool clear = false;  ///< a wire hangs by itself with the view free to the ground
  bool joined = false; ///< some wires meet
};

double
chainLength(const std::vector<WireWithEnds>& wires, std::size_t start)
{
  double length = wires[start].model().length();
  for (int side = 0; side < 2; ++side) {
    std::size_t w = start;
    int out = side;
    for (std::size_t steps = 0; steps < wires.size(); ++steps) {
      const End& end = wires[w].ends[static_cast<std::size_t>(out)];
      if (end.partner < 0 || static_cast<std::size_t>(end.partner) == start)
        break;
      w = static_cast<std::size_t>(end.partner);
      out = 1 - end.partner_side;
      length += wires[w].model().length();
    }
  }
  return length;
}

/** Part of a wire below which, and beside that, a scan sees nothing near: not so on
 * roofs. */
double
openBelow(const SpanModel& m, const Underside& underside)
{
  double open = 0, all = 0;
  for (double s = m.begin; s <= m.end; s += 1) {
    const Point p = m.at(s);
    bool blocked = false;
    for (const double side : {-beside, 0.0, beside})
      blocked =
          blocked || underside.lowestAt(p.x() - side * m.direction.y(),
                                        p.y() + side * m.direction.x()) > p.z() - deep;
    open += !blocked;
    all += 1;
  }
  return open / all;
}

bool
plausible(const Family& family)
{
  const double bend = family.bend / family.weight;
  if (family.precision > 0) {
    const Bend joint = {family.bends / family.precision,
                        1 / std::sqrt(family.precision)};
    if (joint.rulesOut(flattest))
      return false;
  }
  if (family.longest >= long_line)
    return family.joined || family.border || bend >= least_bend;
  if (family.border)
    return (family.wires >= many || family.clean >= clean_part * family.occupied) &&
           (family.wires > 1 || family.single >= short_line);
  return family.clear || (family.single >= short_line && bend >= clear_bend &&
                          family.occupied >= lone_cover * family.bins &&
                          family.clean >= clean_part * family.occupied);
}

Groups
gatherFamilies(const std::vector<WireWithEnds>& wires)
{
  Groups families(wires.size());
  unitePartners(families, wires);
  uniteNeighbors(
      families, wires, company_reach, [](const WireWithEnds& a, const WireWithEnds& b) {
        const Parallel parallel = compare(a.model(), b.model());
        return parallel.distance <= company_reach &&
               parallel.overlap >=
                   company_part * std::max(a.model().length(), b.model().length());
      });
  return families;
}

/** What happens at the ends of a wire. */
struct Surroundings {
  bool joined = false; ///< another wire goes on there
  bool border = false; ///< the data end there
};

Surroundings
lookBeyond(const WireWithEnds& wire, const Underside& underside)
{
  Surroundings beyond;
  for (int side = 0; side < 2; ++side) {
    beyond.joined =
        beyond.joined || wire.ends[static_cast<std::size_t>(side)].partner >= 0;
    beyond.border = beyond.border || leavesData(wire.model(), side, underside);
  }
  return beyond;
}

void
addBend(Family& family, const WireWithEnds& wire, const Points& points)
{
  const SpanModel& m = wire.model();
  const double weight = std::pow(m.length(), 3);
  // What the points say, not what the prior of the fit does.
  const double vague = 2 * m.sigma * std::sqrt(m.covariance(2, 2));
  family.bend += weight * (m.z[2] - vague);
  family.weight += weight;
  if (m.length() >= telling_length) {
    const Bend own = bendOf(wire.strand.piece, points);
    family.bends += own.value / (own.spread * own.spread);
    family.precision += 1 / (own.spread * own.spread);
  }
}

void
addEvidence(Family& family,
            const SpanModel& m,
            const Evidence& evidence,
            const Underside& underside)
{
  family.clean += evidence.clean;
  family.occupied += evidence.occupied;
  family.bins += evidence.bins;
  family.clear = family.clear || (m.length() >= lone_length &&
                                  evidence.slope + evidence.chord <= steep &&
                                  evidence.clean >= lone_clean * evidence.occupied &&
                                  evidence.occupied >= lone_cover * evidence.bins &&
                                  openBelow(m, underside) >= lone_open);
}

// Weighs a wire as if its points were not yet its own.
Evidence
weighAnew(Growth& growth, const Piece& piece, const PowerLineSettings& settings)
{
  growth.claim(piece, Growth::nobody);
  const Evidence evidence = weigh(growth, piece, settings);
  growth.claim(piece, 0);
  return evidence;
}

// Whether a wire of a short chain inside the data is a rope: steep from end to end, and
// taut.
bool
isRope(const SpanModel& m, const Surroundings& beyond)
{
  const double rise = SpanModel::value(m.z, m.end) - SpanModel::value(m.z, m.begin);
  return !beyond.border && std::abs(rise) > steep * m.length() && m.z[2] < clear_bend;
}

// Whether a short wire ends at nothing and has few points.
bool
isStray(const SpanModel& m, const Evidence& evidence, const Surroundings& beyond)
{
  return evidence.occupied < lone_cover * evidence.bins && m.length() < stray_length &&
         !beyond.joined && !beyond.border;
}

// Keeps the wires marked in \a keep, and frees the points of the others.
void
keepOnly(const std::vector<char>& keep,
         std::vector<WireWithEnds>& wires,
         Growth& growth)
{
  std::vector<int> place(wires.size(), -1);
  std::vector<WireWithEnds> kept;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    if (keep[w] == 0) {
      release(wires[w], growth);
      continue;
    }
    place[w] = static_cast<int>(kept.size());
    kept.push_back(wires[w]);
  }
  for (WireWithEnds& wire : kept)
    for (End& end : wire.ends)
      if (end.partner >= 0) {
        end.partner = place[static_cast<std::size_t>(end.partner)];
        end.fixed = end.partner >= 0;
      }
  wires = std::move(kept);
}

bool
isMisled(const WireWithEnds& wire)
{
  const SpanModel& m = wire.model();
  const double from = m.along(wire.ends[0].place), to = m.along(wire.ends[1].place);
  return to - from < std::max(least_hanging, hanging_part * m.length()) ||
         std::max(m.distance(wire.ends[0].place), m.distance(wire.ends[1].place)) >
             farthest_off;
}

} // namespace

bool
dropMisled(std::vector<WireWithEnds>& wires, Growth& growth)
{
  const auto kept = std::stable_partition(
      wires.begin(), wires.end(), [](const WireWithEnds& w) { return !isMisled(w); });
  const bool any = kept != wires.end();
  for (auto wire = kept; wire != wires.end(); ++wire)
    release(*wire, growth);
  wires.erase(kept, wires.end());
  return any;
}

void
dropUnlikely(std::vector<WireWithEnds>& wires,
             Growth& growth,
             const Underside& underside,
             const PowerLineSettings& settings)
{
  Groups family_of = gatherFamilies(wires);
  std::vector<Family> families(wires.size());
  std::vector<char> keep(wires.size(), 1);
  for (std::size_t w = 0; w < wires.size(); ++w) {
    const SpanModel& m = wires[w].model();
    const double chain = chainLength(wires, w);
    const Surroundings beyond = lookBeyond(wires[w], underside);
    Family& family = families[family_of.root(w)];
    ++family.wires;
    family.longest = std::max(family.longest, chain);
    family.single = std::max(family.single, m.length());
    family.joined = family.joined || beyond.joined;
    family.border = family.border || beyond.border;
    addBend(family, wires[w], growth.candidates().points);
    if (chain >= long_line)
      continue; // it speaks for itself
    const Evidence evidence = weighAnew(growth, wires[w].strand.piece, settings);
    addEvidence(family, m, evidence, underside);
    // Unlikely whatever its family says.
    keep[w] = !isRope(m, beyond) && !isStray(m, evidence, beyond);
  }
  for (std::size_t w = 0; w < wires.size(); ++w)
    keep[w] = keep[w] != 0 && plausible(families[family_of.root(w)]);
  keepOnly(keep, wires, growth);
}

} // namespace linelet::powerline
