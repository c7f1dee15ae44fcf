// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/supports/carry_to_supports.h"

#include <algorithm>
#include <cmath>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/data_border.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/beside_company.h"
#include "powerline/spans/joints.h"

namespace linelet::powerline {

namespace {

constexpr double own_place =
    2; // meters between wires of a support, if only one is known
// Standard deviation beyond which a wire's position counts as unknown.
constexpr double most_vague = 0.3; // meters

/** A place where a wire hangs. */
struct Carried {
  Point place;
  double vague = 0; ///< standard deviation, meters
};

// Where \a wire hangs at \a s of its own model, from its own points and from its offset
// to \a company.
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
  // Sideways, a wire is straight except for wind.
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
