// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/spans/company.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "powerline/line_priors.h"
#include "powerline/pieces/candidates.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/kinks.h"
#include "powerline/pieces/parallel.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/beside_company.h"
#include "powerline/spans/joints.h"

namespace linelet::powerline {

namespace {

constexpr double explained_part = 0.9; // of the points of both parts
constexpr double widest_cut = 0.6;     // meters, first fit of two parts

// Joins two parts into one wire that hangs like \a company; without members if they are
// not one.
Piece
joinedAs(const SpanModel& company,
         const Piece& a,
         const Piece& b,
         Growth& growth,
         const PowerLineSettings& settings)
{
  const Points& points = growth.candidates().points;
  const Offset first = offsetFrom(company, a, points),
               second = offsetFrom(company, b, points);
  const auto middle = [&](const Piece& piece) {
    return company.along(piece.model.at((piece.model.begin + piece.model.end) / 2));
  };
  const double far = std::abs(middle(a) - middle(b));
  const double vague = std::hypot(second.spread, vagueAt(first, far));
  Piece joined;
  if ((first.mean - second.mean).norm() > priors.spread * vague)
    return joined;
  joined.model = company;
  joined.model.t[0] += (first.mean[0] + second.mean[0]) / 2;
  joined.model.z[0] += (first.mean[1] + second.mean[1]) / 2;
  joined.members = a.members;
  joined.members.insert(joined.members.end(), b.members.begin(), b.members.end());
  const double both = static_cast<double>(joined.members.size());
  SpanModel& m = joined.model;
  if (!fit(m, points, joined.members, widest_cut) ||
      !fit(m, points, joined.members, joined.cut()))
    return {};
  updateExtent(joined, points);
  m = m.reframed();
  if (!growth.collect(joined, m.tolerance) ||
      static_cast<double>(joined.members.size()) < explained_part * both ||
      !weigh(growth, joined, settings).hangs || !findKinks(joined, points).empty())
    return {};
  return joined;
}

// The wires that hang beside most of wire \a a.
std::vector<std::size_t>
companyOf(std::size_t a, const std::vector<WireWithEnds>& wires)
{
  std::vector<std::size_t> found;
  for (std::size_t x = 0; x < wires.size(); ++x)
    if (x != a && isCompany(wires[a].model(), wires[x].model()))
      found.push_back(x);
  return found;
}

} // namespace

void
joinBesideCompany(std::vector<WireWithEnds>& wires,
                  Growth& growth,
                  const PowerLineSettings& settings)
{
  std::vector<char> taken(wires.size(), 0);
  for (std::size_t a = 0; a < wires.size(); ++a) {
    std::optional<std::vector<std::size_t>> beside; // a in its current form
    for (std::size_t b = 0; b < wires.size() && taken[a] == 0; ++b) {
      Piece& first = wires[a].strand.piece;
      const Piece& second = wires[b].strand.piece;
      if (a == b || taken[b] != 0 || first.thickness > 0 || second.thickness > 0)
        continue;
      const SpanModel& m = first.model;
      const double from = m.along(second.model.at(second.model.begin));
      const double to = m.along(second.model.at(second.model.end));
      const double gap =
          std::max(std::min(from, to) - m.end, m.begin - std::max(from, to));
      if (gap < 0 || gap > settings.max_gap)
        continue;
      if (!beside)
        beside = companyOf(a, wires);
      for (const std::size_t x : *beside) {
        const SpanModel& company = wires[x].model();
        if (x == b || taken[x] != 0 || !isCompany(second.model, company))
          continue;
        growth.claim(first, Growth::nobody);
        growth.claim(second, Growth::nobody);
        Piece joined = joinedAs(company, first, second, growth, settings);
        const bool one = !joined.members.empty();
        if (one) {
          first = std::move(joined);
          for (Piece& companion : wires[b].strand.companions)
            wires[a].strand.companions.push_back(std::move(companion));
          taken[b] = 1;
        }
        else
          growth.claim(second, 0);
        growth.claim(first, 0);
        if (one) {
          beside.reset();
          break;
        }
      }
    }
  }
  std::size_t place = 0;
  wires.erase(std::remove_if(wires.begin(),
                             wires.end(),
                             [&](const WireWithEnds&) { return taken[place++] != 0; }),
              wires.end());
}

} // namespace linelet::powerline
