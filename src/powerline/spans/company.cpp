// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/spans/company.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "powerline/line_priors.h"
#include "powerline/pieces/candidates.h"
#include "powerline/pieces/data_border.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/kinks.h"
#include "powerline/pieces/parallel.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/joints.h"

namespace linelet::powerline {

namespace {

constexpr LinePriors priors;
constexpr double company_part = 0.7;   // of the length of a wire, beside the other
constexpr double explained_part = 0.9; // of the points of both parts
constexpr double widest_cut = 0.6;     // meters, first fit of two parts
constexpr double own_place =
    2; // meters between wires of a support, if only one is known
// Standard deviation of a place where nobody can tell any more where a wire is.
constexpr double most_vague = 0.3; // meters

/** How a wire hangs beside another: to the left and upwards. */
struct Offset {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double spread = 0; ///< standard deviation of the mean, meters
};

Offset
offsetFrom(const SpanModel& company, const Piece& piece, const Points& points)
{
  Offset offset;
  double squares = 0;
  for (const Index i : piece.members)
    offset.mean += company.residual(points[i], company.along(points[i]));
  const double n = static_cast<double>(piece.members.size());
  offset.mean /= n;
  for (const Index i : piece.members)
    squares += (company.residual(points[i], company.along(points[i])) - offset.mean)
                   .squaredNorm();
  offset.spread = std::sqrt(squares / 2 / n / n);
  return offset;
}

// Standard deviation, at a place \a far meters away, of where a wire hangs beside one
// of its span.
double
vagueAt(const Offset& offset, double far)
{
  return std::hypot(offset.spread, priors.alike * far);
}

bool
isCompany(const SpanModel& m, const SpanModel& other)
{
  const Parallel parallel = compare(m, other);
  return parallel.overlap >= company_part * m.length() &&
         parallel.distance <= priors.company_reach;
}

// One wire of two parts, as \a company hangs; without members where they are none.
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

} // namespace

void
joinBesideCompany(std::vector<WireWithEnds>& wires,
                  Growth& growth,
                  const PowerLineSettings& settings)
{
  std::vector<char> taken(wires.size(), 0);
  for (std::size_t a = 0; a < wires.size(); ++a)
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
      for (std::size_t x = 0; x < wires.size(); ++x) {
        const SpanModel& company = wires[x].model();
        if (x == a || x == b || taken[x] != 0 || !isCompany(m, company) ||
            !isCompany(second.model, company))
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
        if (one)
          break;
      }
    }
  std::size_t place = 0;
  wires.erase(std::remove_if(wires.begin(),
                             wires.end(),
                             [&](const WireWithEnds&) { return taken[place++] != 0; }),
              wires.end());
}

namespace {

/** A place that a wire hangs at. */
struct Carried {
  Point place;
  double vague = 0; ///< standard deviation, meters
};

// Where \a wire hangs at \a s of its own model, by its own points and by how it hangs
// beside \a company.
Carried
carriedTo(const WireWithEnds& wire,
          double s,
          const SpanModel& company,
          const Points& points)
{
  const SpanModel& m = wire.model();
  const Piece& piece = wire.strand.piece;
  const Point own = m.at(s);
  const Offset offset = offsetFrom(company, piece, points);
  const double far = std::abs(s - (m.begin + m.end) / 2);
  const double beside = std::max(1e-3, vagueAt(offset, far));
  const double n = static_cast<double>(piece.members.size());
  // Across, a wire is straight but for the wind.
  const double across =
      m.sigma * std::sqrt((1 + 12 * std::pow(far / std::max(1.0, m.length()), 2)) / n);
  const double up = std::max(1e-3, m.uncertainty(s));
  const double at = company.along(own);
  SpanModel shifted = company;
  shifted.t[0] += offset.mean[0];
  shifted.z[0] += offset.mean[1];
  const Point there = shifted.at(at);
  const auto share = [&](double vague) {
    return beside * beside / (beside * beside + vague * vague); // of its own points
  };
  Carried carried;
  carried.place.head<2>() = there.head<2>() + share(across) * (own - there).head<2>();
  carried.place.z() = there.z() + share(up) * (own - there).z();
  const auto both = [&](double vague) { return std::sqrt(share(vague)) * vague; };
  carried.vague = std::max(both(std::max(1e-3, across)), both(up));
  return carried;
}

} // namespace

void
carryBesideCompany(std::vector<WireWithEnds>& wires,
                   const std::vector<Tower>& towers,
                   const Growth& growth,
                   const Underside& underside,
                   const PowerLineSettings& settings)
{
  const Points& points = growth.candidates().points;
  for (WireWithEnds& wire : wires)
    for (int side = 0; side < 2; ++side) {
      End& end = wire.ends[static_cast<std::size_t>(side)];
      const SpanModel& m = wire.model();
      if (end.fixed || end.support >= 0 || wire.leaves[0] || wire.leaves[1] ||
          wire.strand.piece.thickness > 0 || leavesData(m, side, underside))
        continue;
      Carried best;
      best.vague = most_vague;
      for (std::size_t t = 0; t < towers.size(); ++t)
        for (const auto& [w, its] : towers[t].ends) {
          const WireWithEnds& other = wires[static_cast<std::size_t>(w)];
          const End& held = other.ends[static_cast<std::size_t>(its)];
          if (&other == &wire || !held.fixed ||
              other.outward(its).dot(wire.outward(side)) < 0 ||
              !isCompany(m, other.model()))
            continue;
          const Crossarm& arm = towers[t].arm;
          const Eigen::Vector2d level =
              arm.along - arm.turn * Eigen::Vector2d(-arm.along.y(), arm.along.x());
          const double rate = level.dot(m.direction);
          const double edge = wire.edge(side);
          const double on = -level.dot(m.at(edge).head<2>() - arm.center) / rate;
          const double way = side == 0 ? -on : on;
          if (!(way > 0) || way > settings.max_gap)
            continue;
          const Carried carried = carriedTo(wire, edge + on, other.model(), points);
          const double wide = std::max(own_place, 2 * towers[t].reach);
          if (carried.vague >= best.vague || (carried.place - held.place).norm() > wide)
            continue;
          best = carried;
          end.support = static_cast<int>(t);
        }
      if (best.vague >= most_vague)
        continue;
      end.place = best.place;
      end.fixed = true;
    }
}

} // namespace linelet::powerline
