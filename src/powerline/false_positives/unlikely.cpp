// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/false_positives/unlikely.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "powerline/false_positives/wire_family.h"
#include "powerline/line_priors.h"
#include "powerline/pieces/bend.h"
#include "powerline/pieces/data_border.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/open_below.h"
#include "powerline/pieces/parallel.h"
#include "powerline/pieces/scan_scatter.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/wire_groups.h"
#include "powerline/spans/wire_scatter.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

namespace {

constexpr double company_part = 0.35; // of the length of the longer

constexpr double stray_length = 40; // meters of a sparse wire that meets no other

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

/** What lies at the ends of a wire. */
struct Surroundings {
  bool joined = false; ///< another wire continues there
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

/** A wire of a long chain. */
struct LineWire {
  const SpanModel* model;
  std::size_t family;
};

// Whether \a wire leaves a line of another family at one end, as drops to houses do.
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

// Weighs a wire as if its points were still free.
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

// Whether \a other hangs right beside the whole of \a m.
bool
accompanies(const SpanModel& other, const SpanModel& m)
{
  for (const double part : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const Point p = m.at(m.begin + part * m.length());
    const double s = other.along(p);
    if (s < other.begin || s > other.end || other.residual(p, s).norm() > priors.rack)
      return false;
  }
  return true;
}

// Drops wires that are hardly seen where one beside them is: they are its scatter.
// \param[in] seen share of the length of every wire
void
dropScatter(const std::vector<WireWithEnds>& wires,
            const std::vector<double>& seen,
            std::vector<char>& keep)
{
  for (std::size_t w = 0; w < wires.size(); ++w)
    for (std::size_t other = 0; seen[w] < priors.hardly_seen && other < wires.size();
         ++other)
      if (seen[other] > priors.well_seen &&
          accompanies(wires[other].model(), wires[w].model()))
        keep[w] = 0;
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

} // namespace

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
  PowerLineSettings any_length = settings; // the border of the data cuts wires short
  any_length.min_length = 0;
  std::vector<LineWire> lines;
  std::vector<double> seen(wires.size(), 1);
  std::vector<Evidence> evidence_of;
  evidence_of.reserve(wires.size());
  for (const WireWithEnds& wire : wires)
    evidence_of.push_back(weighAnew(growth, wire.strand.piece, any_length));
  const Points& points = growth.candidates().points;
  const ScanScatter scatter = scatterOf(wires, points);
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
    const Bend bend = bendOf(wires[w].strand.piece, points);
    const bool drop = at_begin != at_end && wires[w].strand.piece.thickness == 0 &&
                      bend.value > priors.spread * bend.spread;
    wires[w].leaves = {drop && at_begin, drop && at_end};
    Family& family = families[root];
    family.longest = std::max(family.longest, chain);
    family.single = std::max(family.single, m.length());
    family.joined = family.joined || beyond.joined;
    family.border = family.border || beyond.border;
    addBend(family, wires[w], points, underside);
    addDescent(family, wires, w, underside);
    addJoints(family, wires, w);
    family.open += m.length() * openBelow(m, underside);
    family.length += m.length();
    const Evidence& evidence = evidence_of[w];
    if (evidence.bins > 0)
      seen[w] = static_cast<double>(evidence.occupied) / evidence.bins;
    // A line also predicts how its wires scatter.
    const double excess = wires[w].strand.piece.thickness > 0
                              ? 0
                              : scatter.excess(sampleOf(wires[w].strand.piece, points));
    const bool company =
        (beyond.joined || family.wires >= many) && excess <= priors.spread;
    if (evidence.bins > 0 && evidence.likelihood + logPriorOfScatter(excess) <
                                 (company ? priors.in_company : priors.alone))
      keep[w] = 0;
    if (chain >= long_line)
      continue; // a long chain needs no further evidence
    if (keep[w] == 0)
      continue;
    family.drop = family.drop || drop;
    addEvidence(family, m, evidence, underside);
    // Unlikely, whatever its family.
    keep[w] = drop || (!isRope(m, beyond) && !isStray(m, evidence, beyond));
  }
  for (std::size_t w = 0; w < wires.size(); ++w)
    // Rows and edges of roofs do not become wires by running beside wires.
    keep[w] = keep[w] != 0 && plausible(families[family_of.root(w)], terrain) &&
              (!terrain || isOpenBelow(wires[w].model(), underside));
  dropScatter(wires, seen, keep);
  keepOnly(keep, wires, growth);
}

} // namespace linelet::powerline
