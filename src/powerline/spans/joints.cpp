// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/spans/joints.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <Eigen/Dense>

#include "powerline/line_priors.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/least_hanging.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

namespace {

constexpr double widest_support = 16;  // meters between ends that face each other
constexpr double largest_gap = 1.5;    // meters between wires that meet
constexpr double farthest_reach = 10;  // meters by which a wire is extended
constexpr double least_opposed = -0.5; // cosine between the outward directions
constexpr double end_spread = 3;       // meters, from the last point to the support
constexpr double gap_deviations = 3;   // of the gap between wires that share a point

// Variance of a model's position: of the fit, and of what a stiff curve cannot follow,
// estimated by the scatter of its points.
double
varianceAt(const SpanModel& model, double s)
{
  return std::pow(model.uncertainty(s), 2) + model.sigma * model.sigma;
}

// Whether a wire hangs between its other end and a support at \a place, rather than
// lying mostly beyond it.
bool
hangsFrom(const SpanModel& model, int side, double place)
{
  return (side == 0 ? model.end - place : place - model.begin) >= leastHanging(model);
}

} // namespace

Meeting
meet(const WireWithEnds& a,
     int side_a,
     const WireWithEnds& b,
     int side_b,
     const Crossarm& arm)
{
  const SpanModel& p = a.model();
  const SpanModel& q = b.model();
  const Eigen::Vector2d start(a.edge(side_a), b.edge(side_b));
  Eigen::Vector2d s = start;
  const auto tangent = [](const SpanModel& m, double at) {
    const double left = SpanModel::slope(m.t, at);
    return Point(m.direction.x() - left * m.direction.y(),
                 m.direction.y() + left * m.direction.x(),
                 m.rise(at));
  };
  // Gauss-Newton on the gap, the distance from the ends and from the crossarm.
  for (int iteration = 0; iteration < 8; ++iteration) {
    const Point dp = tangent(p, s[0]), dq = tangent(q, s[1]);
    const Point gap = p.at(s[0]) - q.at(s[1]);
    Eigen::Matrix2d normal = Eigen::Matrix2d::Identity() / (end_spread * end_spread);
    Eigen::Vector2d right = (start - s) / (end_spread * end_spread);
    Eigen::Matrix<double, 3, 2> jacobian;
    jacobian << dp, -dq;
    normal +=
        jacobian.transpose() * jacobian / (priors.point_noise * priors.point_noise);
    right -= jacobian.transpose() * gap / (priors.point_noise * priors.point_noise);
    if (arm.spread >= 0) {
      const Eigen::Vector2d across(-arm.along.y(), arm.along.x());
      const Eigen::Vector2d level = arm.along - arm.turn * across;
      const double weight = 1 / std::pow(std::max(0.1, arm.spread), 2);
      const Point places[2] = {p.at(s[0]), q.at(s[1])};
      const Point slopes[2] = {dp, dq};
      for (int k = 0; k < 2; ++k) {
        const double off = level.dot(places[k].head<2>() - arm.center);
        const double rate = level.dot(slopes[k].head<2>());
        normal(k, k) += weight * rate * rate;
        right[k] -= weight * rate * off;
      }
    }
    s += normal.ldlt().solve(right);
  }
  Meeting m;
  m.a = s[0];
  m.b = s[1];
  m.places = {p.at(s[0]), q.at(s[1])};
  m.gap = (m.places[0] - m.places[1]).norm();
  if (m.gap <= gap_deviations * std::sqrt(varianceAt(p, s[0]) + varianceAt(q, s[1])))
    m.places.fill((m.places[0] + m.places[1]) / 2);
  return m;
}

void
matchEnds(std::vector<WireWithEnds>& wires)
{
  struct Place {
    Point at;
    int wire, side;
  };
  std::vector<Place> ends;
  for (std::size_t w = 0; w < wires.size(); ++w)
    for (int side = 0; side < 2; ++side) {
      const Point at = wires[w].model().at(wires[w].edge(side));
      wires[w].ends[static_cast<std::size_t>(side)] = {};
      wires[w].ends[static_cast<std::size_t>(side)].place = at;
      if (!wires[w].leaves[static_cast<std::size_t>(side)])
        ends.push_back({at, static_cast<int>(w), side});
    }
  std::sort(ends.begin(), ends.end(), [](const Place& a, const Place& b) {
    return std::tuple(a.at.x(), a.wire, a.side) < std::tuple(b.at.x(), b.wire, b.side);
  });
  struct Match {
    double cost;
    std::size_t a, b;
  };
  std::vector<Match> matches;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t k = i + 1;
         k < ends.size() && ends[k].at.x() <= ends[i].at.x() + widest_support;
         ++k) {
      if (ends[i].wire == ends[k].wire ||
          (ends[i].at - ends[k].at).head<2>().norm() > widest_support)
        continue;
      const WireWithEnds& a = wires[static_cast<std::size_t>(ends[i].wire)];
      const WireWithEnds& b = wires[static_cast<std::size_t>(ends[k].wire)];
      if (a.outward(ends[i].side).dot(b.outward(ends[k].side)) > least_opposed)
        continue;
      const Meeting m = meet(a, ends[i].side, b, ends[k].side);
      const double reach_a = std::abs(m.a - a.edge(ends[i].side));
      const double reach_b = std::abs(m.b - b.edge(ends[k].side));
      if (m.gap > largest_gap || std::max(reach_a, reach_b) > farthest_reach ||
          !hangsFrom(a.model(), ends[i].side, m.a) ||
          !hangsFrom(b.model(), ends[k].side, m.b))
        continue;
      matches.push_back({m.gap + 0.1 * (reach_a + reach_b), i, k});
    }
  std::sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) {
    return std::tuple(a.cost, a.a, a.b) < std::tuple(b.cost, b.a, b.b);
  });
  for (const Match& match : matches) {
    const Place& i = ends[match.a];
    const Place& k = ends[match.b];
    End& a =
        wires[static_cast<std::size_t>(i.wire)].ends[static_cast<std::size_t>(i.side)];
    End& b =
        wires[static_cast<std::size_t>(k.wire)].ends[static_cast<std::size_t>(k.side)];
    if (a.partner >= 0 || b.partner >= 0)
      continue;
    a.partner = k.wire;
    a.partner_side = k.side;
    b.partner = i.wire;
    b.partner_side = i.side;
    a.fixed = b.fixed = true;
    const Meeting m = meet(wires[static_cast<std::size_t>(i.wire)],
                           i.side,
                           wires[static_cast<std::size_t>(k.wire)],
                           k.side);
    a.place = m.places[0];
    b.place = m.places[1];
  }
}

} // namespace linelet::powerline
