// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "powerline/evidence.h"
#include "powerline/false_positives.h"
#include "powerline/groups.h"
#include "powerline/joints.h"
#include "powerline/line_priors.h"

namespace linelet::powerline {

namespace {

constexpr double company_part = 0.35; // of the length of the longer
constexpr double steep = 0.12;        // slope between the ends
constexpr double least_bend = 1e-4;   // z2 of a wire, 1/meters: a = 5 km
constexpr double clear_bend = 2e-4;   // of a line so short that it hangs from poles
constexpr LinePriors priors;
constexpr double long_line = 60;    // meters, from which a line speaks for itself
constexpr double short_line = 25;   // meters, the least inside the data
constexpr std::size_t many = 4;     // wires of a family that prove each other
constexpr double clean_part = 0.75; // of the length of short wires at the border

constexpr double lone_length = 18;   // meters of a lone wire in the clear
constexpr double lone_clean = 0.8;   // of its bins
constexpr double stray_length = 40;  // meters of a thinly covered wire that meets none
constexpr double lone_cover = 0.5;   // of the bins of a line inside the data
constexpr double lone_open = 0.8;    // of its length, with nothing but deep below
constexpr double deep = 1.5;         // meters below a wire
constexpr double beside = 1.25;      // meters, looked at on both sides
constexpr double itself_reach = 0.5; // meters of height, of its own points

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
  double least = 0;                ///< that bends are at least, weighted alike
  double open = 0, length = 0;     ///< with nothing but deep below; of all wires
  double clean = 0, occupied = 0, bins = 0; ///< sums of the evidence of short chains
  bool drop = false;                        ///< a wire leaves another line
  bool border = false;                      ///< a wire leaves the data
  bool clear = false;  ///< a wire hangs by itself with the view free to the ground
  bool joined = false; ///< some wires meet
  double stubs = 0;    ///< pairs that meet at a support, cut off by the data's border
  double descent = 0;  ///< sum of their slopes away from it
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
 * roofs and rocks. Right below, a thin scan may see nothing but the wire itself. */
double
openBelow(const SpanModel& m, const Underside& underside)
{
  double open = 0, all = 0;
  for (double s = m.begin; s <= m.end; s += 1) {
    const Point p = m.at(s);
    bool blocked = false;
    for (const double side : {-beside, 0.0, beside}) {
      const double lowest = underside.lowestAt(p.x() - side * m.direction.y(),
                                               p.y() + side * m.direction.x());
      const bool itself = side == 0 && std::abs(lowest - p.z()) < itself_reach;
      blocked = blocked || (lowest > p.z() - deep && !itself);
    }
    open += !blocked;
    all += 1;
  }
  return open / all;
}

bool
plausible(const Family& family, bool terrain)
{
  const double bend = family.bend / family.weight;
  // Too short to be seen to bend, what falls off to both sides of a support hangs
  // there: 4 sag / span at the end of a span.
  const bool hangs =
      family.stubs > 0 && family.descent >= 2 * 4 * priors.least_sag * family.stubs;
  if ((!hangs &&
       family.bends - family.least < -priors.spread * std::sqrt(family.precision)) ||
      (terrain && family.open < priors.open * family.length))
    return false;
  if (family.drop)
    return true;
  if (family.longest >= long_line)
    return family.joined || family.border || bend >= least_bend;
  if (family.border)
    return (family.wires >= many || family.clean >= clean_part * family.occupied) &&
           (family.wires > 1 || family.single >= short_line);
  // Alone, it must be seen to hang.
  return family.bends > priors.spread * std::sqrt(family.precision) &&
         (family.clear || (family.single >= short_line && bend >= clear_bend &&
                           family.occupied >= lone_cover * family.bins &&
                           family.clean >= clean_part * family.occupied));
}

Groups
gatherFamilies(const std::vector<WireWithEnds>& wires)
{
  Groups families(wires.size());
  unitePartners(families, wires);
  uniteNeighbors(families,
                 wires,
                 priors.company_reach,
                 [](const WireWithEnds& a, const WireWithEnds& b) {
                   const Parallel parallel = compare(a.model(), b.model());
                   return parallel.distance <= priors.company_reach &&
                          parallel.overlap >=
                              company_part *
                                  std::max(a.model().length(), b.model().length());
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

// A wire that ends at nothing but a hidden part shows most of its span.
double
largestSpan(const WireWithEnds& wire, const Underside& underside)
{
  const SpanModel& m = wire.model();
  if (wire.ends[0].partner >= 0 && wire.ends[1].partner >= 0)
    return m.length();
  return leavesData(m, 0, underside) || leavesData(m, 1, underside)
             ? std::numeric_limits<double>::infinity()
             : priors.longer * m.length();
}

void
addBend(Family& family,
        const WireWithEnds& wire,
        const Points& points,
        const Underside& underside)
{
  const SpanModel& m = wire.model();
  const double weight = std::pow(m.length(), 3);
  // What the points say, not what the prior of the fit does.
  const double vague = 2 * m.sigma * std::sqrt(m.covariance(2, 2));
  family.bend += weight * (m.z[2] - vague);
  family.weight += weight;
  const Bend own = bendOf(wire.strand.piece, points);
  const double precision = 1 / (own.spread * own.spread);
  family.bends += precision * own.value;
  family.least += precision * priors.leastBend(largestSpan(wire, underside));
  family.precision += precision;
}

/** A wire of a long chain. */
struct LineWire {
  const SpanModel* model;
  std::size_t family;
};

// Whether \a wire leaves a line of another family at one end, as what leads to a house
// does.
bool
leaves(const WireWithEnds& wire,
       int side,
       std::size_t family,
       const std::vector<LineWire>& lines)
{
  const SpanModel& m = wire.model();
  if (m.length() > priors.longest_drop)
    return false;
  const double out = side == 0 ? -1 : 1;
  return std::any_of(lines.begin(), lines.end(), [&](const LineWire& of) {
    const SpanModel* line = of.model;
    for (double on = -priors.drop_reach; of.family != family && on <= priors.drop_reach;
         on += 0.5) {
      const Point p = m.at(wire.edge(side) + out * on);
      const double s = line->along(p);
      if (s < line->begin - priors.drop_beside || s > line->end + priors.drop_beside)
        continue;
      const Point offset = p - line->at(s);
      if (offset.head<2>().norm() <= priors.drop_beside &&
          offset.z() >= -priors.drop_below && offset.z() <= priors.drop_beside)
        return true;
    }
    return false;
  });
}

// Slope of a wire from \a side on to its other end.
double
slopeFrom(const SpanModel& m, int side)
{
  return (side == 0 ? 1 : -1) * m.rise((m.begin + m.end) / 2);
}

void
addDescent(Family& family,
           const std::vector<WireWithEnds>& wires,
           std::size_t w,
           const Underside& underside)
{
  for (int side = 0; side < 2; ++side) {
    const End& end = wires[w].ends[static_cast<std::size_t>(side)];
    if (end.partner <= static_cast<int>(w))
      continue;
    const SpanModel& m = wires[w].model();
    const SpanModel& other = wires[static_cast<std::size_t>(end.partner)].model();
    if (!leavesData(m, 1 - side, underside) ||
        !leavesData(other, 1 - end.partner_side, underside))
      continue;
    family.stubs += 1;
    family.descent -= slopeFrom(m, side) + slopeFrom(other, end.partner_side);
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
  const double rise = m.height(m.end) - m.height(m.begin);
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
             bool terrain,
             const PowerLineSettings& settings)
{
  Groups family_of = gatherFamilies(wires);
  std::vector<Family> families(wires.size());
  std::vector<char> keep(wires.size(), 1);
  PowerLineSettings any_length = settings; // the border of the data leaves short ones
  any_length.min_length = 0;
  std::vector<LineWire> lines;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    ++families[family_of.root(w)].wires;
    if (chainLength(wires, w) >= long_line)
      lines.push_back({&wires[w].model(), family_of.root(w)});
  }
  for (std::size_t w = 0; w < wires.size(); ++w) {
    const SpanModel& m = wires[w].model();
    const double chain = chainLength(wires, w);
    const Surroundings beyond = lookBeyond(wires[w], underside);
    const std::size_t root = family_of.root(w);
    const bool at_begin = leaves(wires[w], 0, root, lines);
    const bool at_end = leaves(wires[w], 1, root, lines);
    const Bend bend = bendOf(wires[w].strand.piece, growth.candidates().points);
    const bool drop = at_begin != at_end && wires[w].strand.piece.thickness == 0 &&
                      bend.value > priors.spread * bend.spread;
    wires[w].leaves = {drop && at_begin, drop && at_end};
    Family& family = families[root];
    family.longest = std::max(family.longest, chain);
    family.single = std::max(family.single, m.length());
    family.joined = family.joined || beyond.joined;
    family.border = family.border || beyond.border;
    addBend(family, wires[w], growth.candidates().points, underside);
    addDescent(family, wires, w, underside);
    family.open += m.length() * openBelow(m, underside);
    family.length += m.length();
    const Evidence evidence = weighAnew(growth, wires[w].strand.piece, any_length);
    const bool company = beyond.joined || family.wires >= many;
    if (evidence.bins > 0 &&
        evidence.likelihood < (company ? priors.in_company : priors.alone))
      keep[w] = 0;
    if (chain >= long_line)
      continue; // it speaks for itself
    if (keep[w] == 0)
      continue;
    family.drop = family.drop || drop;
    addEvidence(family, m, evidence, underside);
    // Unlikely whatever its family says.
    keep[w] = drop || (!isRope(m, beyond) && !isStray(m, evidence, beyond));
  }
  for (std::size_t w = 0; w < wires.size(); ++w)
    keep[w] = keep[w] != 0 && plausible(families[family_of.root(w)], terrain);
  keepOnly(keep, wires, growth);
}

} // namespace linelet::powerline
