// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/false_positives/wire_family.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "powerline/line_priors.h"
#include "powerline/pieces/bend.h"
#include "powerline/pieces/data_border.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/open_below.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

namespace {

constexpr double least_bend = 1e-4;   // z2 of a wire, 1/meters: a = 5 km
constexpr double rather_straight = 2; // nats, 7 to 1
constexpr double clean_part = 0.75;   // of the length of short wires at the border
// Standard deviations by which a lone wire must bend: of a thousand straight rows of
// other points, which a scene may have, six bend by 2.5 by chance, and none by 4.
constexpr double lone_spread = 4;
constexpr double lone_length = 18; // meters of a lone wire in the clear
constexpr double lone_clean = 0.8; // of its bins
constexpr double lone_open = 0.8;  // of its length, with nothing but deep below

// A wire that is visible except for a hidden end shows most of its span.
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

// Slope of a wire from \a side to its other end.
double
slopeFrom(const SpanModel& m, int side)
{
  return (side == 0 ? 1 : -1) * m.rise((m.begin + m.end) / 2);
}

// How much better a straight object such as a pipe explains the bend of \a family, and
// how its wires meet, than wires do, whose bends scatter; nats.
double
straightOverWires(const Family& family)
{
  const double bend = family.bends / family.precision;
  const double noise = 1 / family.precision;
  const double wires = noise + priors.bend_spread * priors.bend_spread;
  const double off = bend - priors.usual_bend;
  return (std::log(wires / noise) + off * off / wires - bend * bend / noise) / 2 +
         family.unbroken;
}

// Slope of a wire at one end, toward its other.
double
slopeAt(const SpanModel& m, int side)
{
  return side == 0 ? m.rise(m.begin) : -m.rise(m.end);
}

// Its variance.
double
slopeVariance(const SpanModel& m, int side)
{
  const Eigen::Vector3d x(0, 1, 2 * (side == 0 ? m.begin : m.end));
  return m.sigma * m.sigma * x.dot(m.covariance * x);
}

} // namespace

bool
plausible(const Family& family, bool terrain)
{
  const double bend = family.bend / family.weight;
  // Wires too short to show a bend hang if they slope down on both sides of a support:
  // 4 sag / span at the end of a span.
  const bool hangs =
      family.stubs > 0 && family.descent >= 2 * 4 * priors.least_sag * family.stubs;
  if ((!hangs &&
       family.bends - family.least < -priors.spread * std::sqrt(family.precision)) ||
      (terrain && family.open < priors.open * family.length))
    return false;
  if (family.drop)
    return true;
  const bool straight = straightOverWires(family) >= rather_straight;
  if (family.longest >= long_line)
    return ((family.joined || family.border) && !straight) || bend >= least_bend;
  // A line cut off by the border of the data may be short, but not straight.
  if (family.border)
    return !straight &&
           (family.wires >= many || family.clean >= clean_part * family.occupied) &&
           (family.wires > 1 || family.single >= priors.short_line);
  // A lone wire must visibly hang.
  return family.bends > lone_spread * std::sqrt(family.precision) &&
         (family.clear || (family.single >= priors.short_line && bend >= clear_bend &&
                           family.occupied >= lone_cover * family.bins &&
                           family.clean >= clean_part * family.occupied));
}

void
addBend(Family& family,
        const WireWithEnds& wire,
        const Points& points,
        const Underside& underside)
{
  const SpanModel& m = wire.model();
  const double weight = std::pow(m.length(), 3);
  // From the points, not the prior of the fit.
  const double vague = 2 * m.sigma * std::sqrt(m.covariance(2, 2));
  family.bend += weight * (m.z[2] - vague);
  family.weight += weight;
  const Bend own = bendOf(wire.strand.piece, points);
  const double precision = 1 / (own.spread * own.spread);
  family.bends += precision * own.value;
  family.least += precision * priors.leastBend(largestSpan(wire, underside));
  family.precision += precision;
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
addJoints(Family& family, const std::vector<WireWithEnds>& wires, std::size_t w)
{
  for (int side = 0; side < 2; ++side) {
    const End& end = wires[w].ends[static_cast<std::size_t>(side)];
    if (end.partner <= static_cast<int>(w))
      continue;
    const WireWithEnds& other = wires[static_cast<std::size_t>(end.partner)];
    const SpanModel &a = wires[w].model(), &b = other.model();
    const double down = -slopeAt(a, side) - slopeAt(b, end.partner_side);
    const double noise = slopeVariance(a, side) + slopeVariance(b, end.partner_side);
    const double hung = noise + priors.joint_spread * priors.joint_spread;
    const double off = down - priors.usual_joint;
    family.unbroken +=
        (std::log(hung / noise) + off * off / hung - down * down / noise) / 2;
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

} // namespace linelet::powerline
