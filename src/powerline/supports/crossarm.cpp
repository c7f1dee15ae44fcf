// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/supports/crossarm.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "powerline/pieces/profile.h"
#include "powerline/spans/joints.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/supports/tower.h"

namespace linelet::powerline {

namespace {

constexpr double kink_reach = 6;   // meters from where the wires meet individually
constexpr double vague_kink = 1.5; // meters; a less certain place is left as it is
constexpr double firmest = 0.15, loosest = 1; // meters, spread of attachment points

/** Two wires that meet at a support, as seen along the line. */
struct Pair {
  Profile heights, offsets;
  double independent; ///< number of independent points
};

/** Frame of a crossarm: across the line, and along it from the crossarm. */
class ArmFrame {
public:
  explicit ArmFrame(const Crossarm& arm)
      : arm_(arm), across_(-arm.along.y(), arm.along.x())
  {
  }

  double
  across(const Point& p) const
  {
    return across_.dot(p.head<2>() - arm_.center);
  }

  double
  along(const Point& p) const
  {
    return arm_.along.dot(p.head<2>() - arm_.center) - arm_.turn * across(p);
  }

private:
  const Crossarm& arm_;
  Eigen::Vector2d across_;
};

Pair
pairOf(const WireWithEnds& a,
       const WireWithEnds& b,
       const Tower& tower,
       const Points& points)
{
  const ArmFrame frame(tower.arm);
  std::vector<std::pair<double, double>> heights, offsets;
  double low = 0, high = 0;
  for (const WireWithEnds* wire : {&a, &b})
    for (const Index i : wire->strand.piece.members) {
      const double s = frame.along(points[i]);
      heights.emplace_back(s, points[i].z() - tower.lowest_arm);
      offsets.emplace_back(s, frame.across(points[i]));
      low = std::min(low, s);
      high = std::max(high, s);
    }
  const double count = static_cast<double>(heights.size());
  return {Profile(std::move(heights)),
          Profile(std::move(offsets)),
          std::min(count, independent * (high - low))};
}

// Log-likelihood, up to a constant, that all pairs bend at \a s.
double
likelihoodAt(const std::vector<Pair>& pairs, double s)
{
  constexpr double all = 1e9;
  double sum = 0;
  for (const Pair& pair : pairs) {
    const double count = pair.heights.count(-all, all);
    const double floor = count * least_residual * least_residual;
    for (const Profile* profile : {&pair.heights, &pair.offsets})
      sum -= pair.independent / 2 *
             std::log((profile->hingeAt(s, -all, all).squares + floor) / count);
  }
  return sum;
}

} // namespace

void
moveToKink(Tower& tower, const std::vector<WireWithEnds>& wires, const Points& points)
{
  std::vector<Pair> pairs;
  for (const auto& [w, side] : tower.ends) {
    const WireWithEnds& wire = wires[static_cast<std::size_t>(w)];
    const End& end = wire.ends[static_cast<std::size_t>(side)];
    if (w < end.partner)
      pairs.push_back(
          pairOf(wire, wires[static_cast<std::size_t>(end.partner)], tower, points));
  }
  if (pairs.empty())
    return;
  std::vector<std::pair<double, double>> tried; // place, log-likelihood
  for (double s = -kink_reach; s <= kink_reach; s += profile_step)
    tried.emplace_back(s, likelihoodAt(pairs, s));
  // Mean and deviation of the place, weighted by likelihood.
  const double best =
      std::max_element(tried.begin(), tried.end(), [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->second;
  double total = 0, sum = 0, squares = 0;
  for (const auto& [s, likelihood] : tried) {
    const double weight = std::exp(likelihood - best);
    total += weight;
    sum += weight * s;
    squares += weight * s * s;
  }
  const double place = sum / total;
  const double spread = std::sqrt(std::max(0.0, squares / total - place * place));
  if (spread > vague_kink)
    return;
  tower.arm.center += place * tower.arm.along;
  tower.arm.spread = std::clamp(spread, firmest, loosest);
}

void
fitCrossarm(Tower& tower, const std::vector<WireWithEnds>& wires)
{
  Crossarm& arm = tower.arm;
  const Eigen::Vector2d across(-arm.along.y(), arm.along.x());
  std::vector<Eigen::Vector2d> places;
  for (const auto& [w, side] : tower.ends)
    if (const End& end =
            wires[static_cast<std::size_t>(w)].ends[static_cast<std::size_t>(side)];
        end.partner >= 0) {
      const Eigen::Vector2d offset = end.place.head<2>() - arm.center;
      places.emplace_back(across.dot(offset), arm.along.dot(offset));
    }
  if (places.size() < 2)
    return;
  Eigen::Vector2d line(0, 0); // place along the line of the crossarm: line0 + line1 u
  for (int iteration = 0; iteration < 5; ++iteration) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    normal(1, 1) = 20; // the crossarm is about square to the line
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    double total = 0, squares = 0;
    for (const Eigen::Vector2d& p : places) {
      const Eigen::Vector2d x(1, p[0]);
      const double off = p[1] - line.dot(x);
      const double w = 1 / (1 + off * off / 0.25);
      normal += w * x * x.transpose();
      right += w * p[1] * x;
      squares += w * off * off;
      total += w;
    }
    line = normal.ldlt().solve(right);
    arm.spread = std::clamp(std::sqrt(squares / total), firmest, loosest);
  }
  arm.center += line[0] * arm.along;
  arm.turn = line[1];
}

} // namespace linelet::powerline
