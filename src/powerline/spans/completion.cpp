// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/spans/completion.h"

#include <algorithm>
#include <cmath>

#include "powerline/line_priors.h"
#include "powerline/pieces/candidates.h"
#include "powerline/pieces/curve_pieces.h"
#include "powerline/pieces/data_border.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/find_pieces.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/open_below.h"
#include "powerline/pieces/scan_scatter.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/beside_company.h"
#include "powerline/spans/joints.h"
#include "powerline/spans/wire_scatter.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

namespace {

constexpr double thin_cover = 0.1; // of the bins of a wire beside others
constexpr double thin_clean = 0.9; // of those, clean
constexpr double patience = 40;    // nats against a wire whose position is known
constexpr double overshoot = 1;    // meters beyond the end of the company
constexpr double stub_reach = 8;   // meters from the end of a wire to its stub
constexpr double stub_gap = 0.5;   // meters between them where they meet
constexpr double least_stub = 4;   // meters
constexpr double aligned = 0.99;

// A stub is as long as the data allow.
bool
goesOn(const std::vector<WireWithEnds>& wires,
       const WireWithEnds& stub,
       const Underside& underside)
{
  const SpanModel& m = stub.model();
  for (int side = 0; side < 2; ++side) {
    if (!leavesData(m, 1 - side, underside))
      continue;
    const Point near = m.at(stub.edge(side));
    for (const WireWithEnds& wire : wires) {
      for (int other = 0; other < 2; ++other) {
        if ((wire.model().at(wire.edge(other)) - near).norm() > stub_reach ||
            wire.outward(other).dot(stub.outward(side)) > -0.5)
          continue;
        const Meeting meeting = meet(wire, other, stub, side);
        if (meeting.gap <= stub_gap &&
            std::abs(meeting.b - stub.edge(side)) <= stub_reach)
          return true;
      }
      if (isCompany(m, wire.model()) &&
          std::abs(m.direction.dot(wire.model().direction)) >= aligned)
        return true;
    }
  }
  return false;
}

} // namespace

void
completeByCompany(std::vector<WireWithEnds>& wires,
                  Growth& growth,
                  const PowerLineSettings& settings)
{
  for (WireWithEnds& wire : wires) {
    Piece& piece = wire.strand.piece;
    const SpanModel& m = piece.model;
    double low = m.begin, high = m.end;
    for (const WireWithEnds& other : wires) {
      if (&other == &wire || !isCompany(m, other.model()))
        continue;
      const double from = m.along(other.model().at(other.model().begin));
      const double to = m.along(other.model().at(other.model().end));
      low = std::min({low, from, to});
      high = std::max({high, from, to});
    }
    if (low > m.begin - bin_length && high < m.end + bin_length)
      continue;
    Piece longer = piece;
    growth.claim(piece, Growth::nobody);
    if (growth.extend(longer, low - overshoot, high + overshoot, false, patience) &&
        longer.model.length() > m.length()) {
      // Beside others a wire may be sparsely covered, if nothing else is near it.
      const Evidence e = weigh(growth, longer, settings);
      if (e.likelihood >= priors.in_company &&
          (e.accepted || (e.sound && e.occupied >= thin_cover * e.bins &&
                          e.clean >= thin_clean * e.occupied)))
        piece = std::move(longer);
    }
    growth.claim(piece, 0);
  }
}

void
addStubs(std::vector<WireWithEnds>& wires,
         Growth& growth,
         const std::vector<Seed>& seeds,
         const std::vector<Curve>& curves,
         const Underside& underside,
         bool terrain,
         const PowerLineSettings& settings)
{
  PowerLineSettings relaxed = settings;
  relaxed.min_length = std::min(least_stub, settings.min_length);
  const Points& points = growth.candidates().points;
  const ScanScatter scatter = scatterOf(wires, points);
  const auto addIfStub = [&](Piece& piece) {
    WireWithEnds stub;
    stub.strand.piece = std::move(piece);
    const Piece& found = stub.strand.piece;
    if ((!weigh(growth, found, relaxed).accepted &&
         !becomesBundle(growth, stub.strand.piece, relaxed)) ||
        (found.thickness == 0 &&
         scatter.excess(sampleOf(found, points)) > priors.spread) ||
        !goesOn(wires, stub, underside) ||
        (terrain && !isOpenBelow(stub.model(), underside)))
      return;
    growth.claim(found, 0);
    wires.push_back(std::move(stub));
  };
  std::vector<char> tried(points.size(), 0);
  const std::size_t count = wires.size();
  for (const Seed& seed : seeds) {
    const Point& p = points[seed.candidate];
    if (tried[seed.candidate] != 0 || growth.owner(seed.candidate) != Growth::nobody)
      continue;
    const bool near = std::any_of(wires.begin(),
                                  wires.begin() + static_cast<std::ptrdiff_t>(count),
                                  [&](const WireWithEnds& w) {
                                    return std::min((w.ends[0].place - p).norm(),
                                                    (w.ends[1].place - p).norm()) <
                                           2 * stub_reach + settings.min_length;
                                  });
    if (!near)
      continue;
    for (Piece& piece : growth.grow(seed)) {
      for (const Index i : piece.members)
        tried[i] = 1;
      addIfStub(piece);
    }
  }
  // What is dense all around spoils seeds, but not always curves.
  forEachPieceAlong(curves, growth, settings.threads, addIfStub);
}

} // namespace linelet::powerline
