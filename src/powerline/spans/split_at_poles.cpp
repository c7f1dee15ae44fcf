// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/spans/split_at_poles.h"

#include <algorithm>
#include <map>
#include <utility>

#include "powerline/line_priors.h"
#include "powerline/pieces/candidates.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/line_poles.h"
#include "powerline/pieces/parallel.h"
#include "powerline/pieces/span_model.h"
#include "powerline/pieces/vertical_slice.h"
#include "powerline/spans/wire_groups.h"
#include "powerline/spans/wire_with_ends.h"
#include "support/parallel_chunks.h"

namespace linelet::powerline {

namespace {

constexpr double same_line = 3;      // meters between wires that share their poles
constexpr double side_by_side = 0.6; // of the shorter one
constexpr double thin_part = 0.3;    // of the points per meter of the whole, in a part

// Low wires that run side by side: their poles carry all of them.
std::vector<std::vector<std::size_t>>
gatherLines(const std::vector<WireWithEnds>& wires, const Candidates& candidates)
{
  std::vector<char> low(wires.size());
  for (std::size_t w = 0; w < wires.size(); ++w)
    low[w] = heightOf(wires[w].strand.piece, candidates) < LinePriors().highest_pole;
  Groups groups(wires.size());
  uniteNeighbors(
      groups, wires, same_line, [&](const WireWithEnds& a, const WireWithEnds& b) {
        const auto place = [&](const WireWithEnds& wire) {
          return static_cast<std::size_t>(&wire - wires.data());
        };
        if (low[place(a)] == 0 || low[place(b)] == 0)
          return false;
        const Parallel parallel = compare(a.model(), b.model());
        return parallel.distance <= same_line &&
               parallel.overlap >=
                   side_by_side * std::min(a.model().length(), b.model().length());
      });
  std::map<std::size_t, std::vector<std::size_t>> lines;
  for (std::size_t w = 0; w < wires.size(); ++w)
    if (low[w] != 0)
      lines[groups.root(w)].push_back(w);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [root, line] : lines)
    result.push_back(std::move(line));
  return result;
}

double
density(const Piece& piece)
{
  return static_cast<double>(piece.members.size()) / piece.model.length();
}

// The part between two poles of a wire that was taken for one span, refitted, first to
// points as far off as that error may have put it. Empty if there is none.
Piece
partOf(const Piece& whole, double low, double high, const Growth& growth)
{
  Piece part;
  part.thickness = whole.thickness;
  SpanModel& m = part.model;
  m = whole.model;
  m.begin = low;
  m.end = high;
  m = m.reframed();
  const double begin = m.begin, end = m.end;
  if (!growth.collect(part, std::max(around_wire, whole.thickness)) ||
      !growth.collect(part, std::max(m.tolerance, whole.thickness)) ||
      density(part) < thin_part * density(whole))
    part.members.clear();
  m.begin = begin; // up to the poles, even where they hide it
  m.end = end;
  return part;
}

// Appends the spans of \a piece between \a poles along it, each claimed.
void
appendSpans(Piece& piece,
            const std::vector<double>& poles,
            Growth& growth,
            std::vector<WireWithEnds>& spans)
{
  growth.claim(piece, Growth::nobody);
  for (std::size_t k = 0; k <= poles.size(); ++k) {
    const double low = k == 0 ? piece.model.begin : poles[k - 1];
    const double high = k == poles.size() ? piece.model.end : poles[k];
    if (high - low < least_piece)
      continue;
    WireWithEnds part;
    part.strand.piece = partOf(piece, low, high, growth);
    if (part.strand.piece.members.empty())
      continue;
    growth.claim(part.strand.piece, 0);
    spans.push_back(std::move(part));
  }
}

/** \brief Places of poles along a wire and along each of its companions. */
struct PolesOfStrand {
  std::vector<double> piece;
  std::vector<std::vector<double>> companions;
};

} // namespace

void
splitAtPoles(std::vector<WireWithEnds>& wires, Growth& growth, unsigned threads)
{
  std::vector<PolesOfStrand> poles(wires.size());
  const auto lines = gatherLines(wires, growth.candidates());
  forEachChunk(lines.size(), 1, threads, [&](std::size_t k, std::size_t) {
    std::vector<const Piece*> members;
    for (const std::size_t w : lines[k])
      members.push_back(&wires[w].strand.piece);
    const LinePoles found(members, growth);
    for (const std::size_t w : lines[k]) {
      poles[w].piece = found.along(wires[w].model());
      for (const Piece& companion : wires[w].strand.companions)
        poles[w].companions.push_back(found.along(companion.model));
    }
  });
  std::vector<WireWithEnds> result;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    WireWithEnds& wire = wires[w];
    if (poles[w].piece.empty()) {
      result.push_back(std::move(wire));
      continue;
    }
    appendSpans(wire.strand.piece, poles[w].piece, growth, result);
    // A companion too short for the whole may be a wire beside one of its spans.
    for (std::size_t c = 0; c < wire.strand.companions.size(); ++c)
      if (Piece& companion = wire.strand.companions[c]; poles[w].companions[c].empty())
        result.push_back({{std::move(companion), {}}, {}});
      else
        appendSpans(companion, poles[w].companions[c], growth, result);
  }
  wires = std::move(result);
}

} // namespace linelet::powerline
