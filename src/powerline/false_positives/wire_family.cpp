// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/false_positives/wire_family.h"

#include <cmath>

#include "powerline/line_priors.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr double rather_straight = 2; // nats, 7 to 1

// The mean bend of its wires.
Bend
bendOf(const Family& family)
{
  return {family.bends / family.precision, 1 / std::sqrt(family.precision)};
}

// How much better a straight thing, as a pipe is, explains the bend of \a family and
// how its wires meet than wires do, whose bends scatter; nats.
double
straightOverWires(const Family& family)
{
  const Bend bend = bendOf(family);
  const double noise = bend.spread * bend.spread;
  const double wires = noise + priors.bend_spread * priors.bend_spread;
  const double off = bend.value - priors.usual_bend;
  return (std::log(wires / noise) + off * off / wires -
          bend.value * bend.value / noise) /
             2 +
         family.unbroken;
}

// Slope of a wire at one end, on to its other.
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
plausible(const Family& family)
{
  const bool is_long = family.longest >= long_line;
  // What the border of the data cuts off may be short.
  const bool cut_off =
      family.border && (family.wires > 1 || family.single >= priors.short_line);
  return family.drop ||
         ((is_long || cut_off) && straightOverWires(family) < rather_straight) ||
         (is_long && bendOf(family).isAbove(flattest));
}

void
addBend(Family& family, const Bend& bend)
{
  const double precision = 1 / (bend.spread * bend.spread);
  family.bends += precision * bend.value;
  family.precision += precision;
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

} // namespace linelet::powerline
