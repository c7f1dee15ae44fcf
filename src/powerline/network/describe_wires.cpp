// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/network/describe_wires.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include <linelet/support/threads.h>

#include "powerline/network/fit_catenary.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"
#include "support/parallel_failure.h"

namespace linelet::powerline {

namespace {

constexpr double plain_gap = 8; // meters without a point that are not unusual

std::string
meters(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

void
lower(Wire& wire, double factor, const std::string& why)
{
  wire.confidence *= std::clamp(factor, 0.1, 1.0);
  if (factor < 0.9)
    wire.reason += (wire.reason.empty() ? "" : "; ") + why;
}

void
judge(Wire& wire, const Evidence& evidence, double max_gap)
{
  const double density = static_cast<double>(wire.points) / std::max(1.0, wire.length);
  lower(wire, 0.4 + 0.6 * density, meters(density) + " points per meter");
  if (wire.largest_gap > plain_gap)
    lower(wire,
          1 - 0.6 * (wire.largest_gap - plain_gap) / std::max(1.0, max_gap),
          "gap of " + meters(wire.largest_gap) + " m");
  const double covered =
      static_cast<double>(evidence.occupied) / std::max(1, evidence.bins);
  lower(wire, 0.3 + covered, "points on " + meters(100 * covered) + " % of its length");
  lower(wire, 1 - (wire.rms - 0.1) * 4, "points scatter by " + meters(wire.rms) + " m");
  const double clean =
      static_cast<double>(evidence.clean) / std::max(1, evidence.occupied);
  lower(wire, 0.35 + 0.75 * clean, "other objects close by");
  lower(wire, 0.6 + 0.4 * wire.length / 25, "only " + meters(wire.length) + " m long");
  if (wire.front_support == 0 && wire.back_support == 0)
    lower(wire, 0.85, "no support seen");
}

void
measure(Wire& wire, const WireWithEnds& with_ends, const Points& points)
{
  wire.largest_gap = wire.sag = 0;
  const Catenary& c = wire.curve;
  std::vector<double> places = {c.from, c.to};
  double squares = 0;
  for (const Index i : with_ends.strand.piece.members) {
    places.push_back(std::clamp(c.along(points[i]), c.from, c.to));
    squares += std::pow(c.distance(points[i]), 2);
  }
  wire.points = with_ends.strand.piece.members.size();
  wire.rms =
      std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, wire.points)));
  std::sort(places.begin(), places.end());
  for (std::size_t i = 1; i < places.size(); ++i)
    wire.largest_gap = std::max(wire.largest_gap, places[i] - places[i - 1]);
  wire.length = 0;
  const Points vertices = polyline(wire);
  for (std::size_t i = 1; i < vertices.size(); ++i)
    wire.length += (vertices[i] - vertices[i - 1]).norm();
  const Point chord = wire.back - wire.front;
  wire.span_length = chord.head<2>().norm();
  for (int k = 1; k < 64; ++k) {
    const double part = k / 64.0;
    const double height = wire.front.z() + part * chord.z();
    wire.sag = std::max(wire.sag, height - c.at(c.from + part * (c.to - c.from)).z());
  }
}

} // namespace

void
fitWire(Wire& wire, const WireWithEnds& with_ends, const Points& points)
{
  Points fixed;
  for (const End& end : with_ends.ends)
    if (end.fixed)
      fixed.push_back(end.place);
  Catenary& c = wire.curve;
  const Piece& piece = with_ends.strand.piece;
  c = fitCatenary(piece.model, points, piece.members, fixed, piece.cut());
  if (with_ends.ends[0].fixed)
    c.from = c.along(with_ends.ends[0].place);
  if (with_ends.ends[1].fixed)
    c.to = c.along(with_ends.ends[1].place);
  wire.front = with_ends.ends[0].fixed ? with_ends.ends[0].place : c.at(c.from);
  wire.back = with_ends.ends[1].fixed ? with_ends.ends[1].place : c.at(c.to);
  measure(wire, with_ends, points);
}

std::vector<Wire>
describeWires(const std::vector<WireWithEnds>& wires,
              Growth& growth,
              const PowerLineSettings& settings)
{
  const Points& points = growth.candidates().points;
  std::vector<Wire> result(wires.size());
  const auto count = static_cast<std::ptrdiff_t>(wires.size());
  const auto describe = [&](const WireWithEnds& with_ends, Wire& wire) {
    fitWire(wire, with_ends, points);
    wire.front_support = with_ends.ends[0].support + 1;
    wire.back_support = with_ends.ends[1].support + 1;
    const Piece& piece = with_ends.strand.piece;
    wire.conductors =
        piece.thickness > 0 || !with_ends.strand.companions.empty() ? 2 : 1;
  };
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic) num_threads(threadCount(settings.threads))
  for (std::ptrdiff_t w = 0; w < count; ++w)
    failure.guard([&] {
      describe(wires[static_cast<std::size_t>(w)], result[static_cast<std::size_t>(w)]);
    });
  failure.rethrow();
  PowerLineSettings any_length = settings; // the border of the data cuts wires short
  any_length.min_length = 0;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    // Its own points count as free while a wire is weighed.
    const Piece& piece = wires[w].strand.piece;
    growth.claim(piece, Growth::nobody);
    judge(result[w], weigh(growth, piece, any_length), settings.max_gap);
    growth.claim(piece, 0);
  }
  return result;
}

} // namespace linelet::powerline
