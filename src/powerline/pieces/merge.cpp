// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/merge.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "powerline/pieces/growth.h"
#include "powerline/pieces/kinks.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr double same_direction = 0.99; // cosine between parts of a wire
constexpr double wide_cut = 2;          // meters, first fit of two parts
constexpr double explained_part = 0.85; // of the points of each part
constexpr double largest_overlap =
    0.3; // of the shorter part, unless they are one anyway

// Share of \a members that \a wire explains.
double
explained(const Piece& wire, const Points& points, const Indices& members)
{
  const auto count = std::count_if(members.begin(), members.end(), [&](Index i) {
    return wire.model.distance(points[i]) <= 1.25 * wire.tolerance();
  });
  return static_cast<double>(count) / static_cast<double>(members.size());
}

/** Gap between two pieces along the first, negative where they overlap. */
double
gapBetween(const SpanModel& a, const SpanModel& b)
{
  const double from = a.along(b.at(b.begin)), to = a.along(b.at(b.end));
  return std::max(std::min(from, to) - a.end, a.begin - std::max(from, to));
}

bool
join(
    const Piece& a, const Piece& b, const Points& points, double max_gap, Piece& joined)
{
  const Piece& longer = a.model.length() >= b.model.length() ? a : b;
  const Piece& shorter = &longer == &a ? b : a;
  const SpanModel& l = longer.model;
  const SpanModel& s = shorter.model;
  if (std::abs(l.direction.dot(s.direction)) < same_direction)
    return false;
  const double gap = gapBetween(l, s);
  if (gap > std::min(max_gap, l.length() + s.length()) ||
      gap < -largest_overlap * s.length() - 1)
    return false;
  const double near_end = std::min(l.distance(s.at(s.begin)), l.distance(s.at(s.end)));
  if (near_end > wide_cut)
    return false;

  joined.model = l;
  joined.thickness = std::max(a.thickness, b.thickness);
  joined.members = longer.members;
  joined.members.insert(
      joined.members.end(), shorter.members.begin(), shorter.members.end());
  SpanModel& m = joined.model;
  if (!fit(m, points, joined.members, wide_cut) ||
      !fit(m, points, joined.members, 0.6) ||
      !fit(m, points, joined.members, joined.cut()))
    return false;
  const double from = m.along(s.at(s.begin)), to = m.along(s.at(s.end));
  m.begin = std::min({l.begin, from, to});
  m.end = std::max({l.end, from, to});
  if (m.z[2] * m.length() * m.length() / 4 < -0.1 ||
      explained(joined, points, longer.members) < explained_part ||
      explained(joined, points, shorter.members) < explained_part)
    return false;
  const double apart = std::max(rootMeanSquare(l, points, longer.members),
                                rootMeanSquare(s, points, shorter.members));
  return rootMeanSquare(m, points, joined.members) <= std::max(0.06, 1.3 * apart) &&
         findKinks(joined, points).empty();
}

} // namespace

void
mergePieces(Growth& growth,
            std::vector<Piece>& pieces,
            const PowerLineSettings& settings)
{
  const Points& points = growth.candidates().points;
  for (bool changed = true; changed;) {
    changed = false;
    // Left to right, so that only neighbors in x are compared.
    const auto leftmost = [](const Piece& p) {
      return std::min(p.model.at(p.model.begin).x(), p.model.at(p.model.end).x());
    };
    const auto rightmost = [](const Piece& p) {
      return std::max(p.model.at(p.model.begin).x(), p.model.at(p.model.end).x());
    };
    std::stable_sort(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
      return leftmost(a) < leftmost(b);
    });
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (pieces[i].members.empty())
        continue;
      for (std::size_t k = i + 1; k < pieces.size(); ++k) {
        if (pieces[k].members.empty())
          continue;
        if (leftmost(pieces[k]) > rightmost(pieces[i]) + settings.max_gap)
          break;
        Piece joined;
        if (!join(pieces[i], pieces[k], points, settings.max_gap, joined))
          continue;
        growth.claim(pieces[i], Growth::nobody);
        growth.claim(pieces[k], Growth::nobody);
        joined.model = joined.model.reframed();
        const auto parts =
            static_cast<double>(pieces[i].members.size() + pieces[k].members.size());
        if (!growth.collect(joined,
                            std::max(joined.model.tolerance, joined.thickness)) ||
            !growth.extend(joined) ||
            static_cast<double>(joined.members.size()) < explained_part * parts) {
          growth.claim(pieces[i], 0);
          growth.claim(pieces[k], 0);
          continue;
        }
        growth.claim(joined, 0);
        pieces[i] = std::move(joined);
        pieces[k].members.clear();
        changed = true;
      }
    }
    pieces.erase(std::remove_if(pieces.begin(),
                                pieces.end(),
                                [](const Piece& p) { return p.members.empty(); }),
                 pieces.end());
  }
}

} // namespace linelet::powerline
