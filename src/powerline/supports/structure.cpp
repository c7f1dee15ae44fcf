// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/supports/structure.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "powerline/pieces/vertical_slice.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/supports/tower.h"

namespace linelet::powerline {

namespace {

constexpr double slice = 1;                  // meters of height
constexpr double pole_search = 2;            // meters around the attachment points
constexpr double body_search = 2.5;          // meters around the axis
constexpr double body_flare = 0.12;          // growth of that per meter downward
constexpr double ring_from = 4, ring_to = 7; // meters along the line, must be emptier
constexpr double filled = 0.6;               // of the slices from 3 m to the top
constexpr double filled_alone = 0.4;         // the same if nothing else stands there
constexpr double contrast = 3;    // density of the body over that of its surroundings
constexpr double arm_depth = 3;   // meters that crossarms reach below their wires
constexpr double arm_tip = 2;     // meters, and beyond them
constexpr double widest_foot = 8; // meters, half width

struct Local {
  double u, v, z; // across the line, along it, height
};

Local
local(const Tower& tower, const Point& p)
{
  const Eigen::Vector2d offset = p.head<2>() - tower.arm.center;
  const Eigen::Vector2d across(-tower.arm.along.y(), tower.arm.along.x());
  const double u = across.dot(offset);
  return {u, tower.arm.along.dot(offset) - tower.arm.turn * u, p.z()};
}

double
fillOf(const std::vector<Local>& points,
       double u,
       double v,
       double radius,
       double low,
       double high)
{
  std::set<int> slices;
  for (const Local& p : points)
    if (p.z >= low && p.z < high && std::hypot(p.u - u, p.v - v) <= radius)
      slices.insert(static_cast<int>((p.z - low) / slice));
  return static_cast<double>(slices.size()) /
         std::max(1.0, std::floor((high - low) / slice));
}

bool
findPole(Tower& tower, const std::vector<Local>& points, double low, double high)
{
  double best = 0, best_u = 0, best_v = 0;
  std::size_t tried = 0;
  for (const Local& p : points) {
    if (std::abs(p.v) > pole_search || std::abs(p.u) > tower.reach + pole_search ||
        p.z > high || ++tried > 300)
      continue;
    const double f = fillOf(points, p.u, p.v, pole_radius, low, high);
    if (f > best) {
      best = f;
      best_u = p.u;
      best_v = p.v;
    }
  }
  if (best < filled_alone)
    return false;
  double inside = 0, around = 0;
  for (const Local& p : points)
    if (p.z >= low && p.z < high - 1) {
      const double d = std::hypot(p.u - best_u, p.v - best_v);
      inside += d <= pole_radius;
      around += d > 0.8 && d <= 2;
    }
  // Except for crossarms and ties, a pole has little around itself.
  if (around * (0.4 * 0.4) / (2 * 2 - 0.8 * 0.8) * contrast > inside ||
      around > 2 * inside || (best < filled && (around > 0 || inside < 3)))
    return false;
  const Eigen::Vector2d across(-tower.arm.along.y(), tower.arm.along.x());
  tower.arm.center +=
      best_u * across + (best_v + tower.arm.turn * best_u) * tower.arm.along;
  tower.pole = true;
  tower.half_width = pole_radius;
  return true;
}

// The narrowest straight legs that enclose the points below the crossarms.
void
fitBody(Tower& tower, const std::vector<Local>& points)
{
  struct Level {
    double depth, width;
  };
  std::vector<Level> levels;
  for (double z = tower.lowest_arm - 2; z > tower.base + 2; z -= 2) {
    std::vector<double> widths;
    for (const Local& p : points)
      if (p.z >= z - 2 && p.z < z) {
        const double w = std::max(std::abs(p.u), std::abs(p.v));
        if (w <= widest_foot)
          widths.push_back(w);
      }
    if (widths.size() < 3)
      continue;
    std::sort(widths.begin(), widths.end());
    levels.push_back(
        {tower.lowest_arm - z + 1, widths[(widths.size() - 1) * 95 / 100]});
  }
  tower.half_width = 1.5;
  tower.flare = 0.08;
  std::size_t most = 0;
  for (std::size_t i = 0; i < levels.size(); ++i)
    for (std::size_t k = i + 1; k < levels.size(); ++k) {
      const double flare =
          (levels[k].width - levels[i].width) / (levels[k].depth - levels[i].depth);
      const double width = levels[i].width - flare * levels[i].depth;
      if (flare < 0 || flare > 0.25 || width < 0.3 || width > 4)
        continue;
      const auto count = static_cast<std::size_t>(
          std::count_if(levels.begin(), levels.end(), [&](const Level& l) {
            return std::abs(width + flare * l.depth - l.width) < 0.5;
          }));
      if (count > most) {
        most = count;
        tower.half_width = width;
        tower.flare = flare;
      }
    }
}

} // namespace

void
findStructure(Tower& tower, const Points& points, const Indices& near)
{
  std::vector<Local> all;
  for (const Index i : near)
    all.push_back(local(tower, points[i]));
  const double low = tower.base + 3, high = std::max(low + 1, tower.top - 0.5);
  if (findPole(tower, all, low, high)) {
    tower.seen = true;
    for (const Local& p : all)
      if (std::hypot(p.u, p.v) < pole_search && p.z < tower.top + 4)
        tower.top = std::max(tower.top, p.z);
    return;
  }

  tower.pole = tower.top - tower.base < lowest_pylon;
  if (tower.pole)
    return; // the pole is not visible; what stands there is a tree or a house

  // The center of what stands between the outer wires, high above the trees.
  std::vector<double> along;
  for (const Local& p : all)
    if (p.z > (low + 2 * high) / 3 && std::abs(p.v) < 4 &&
        std::abs(p.u) < tower.reach + 1)
      along.push_back(p.v);
  if (along.size() >= 5 && tower.arm.spread < 0) {
    std::nth_element(along.begin(),
                     along.begin() + static_cast<std::ptrdiff_t>(along.size() / 2),
                     along.end());
    const double shift = along[along.size() / 2];
    tower.arm.center += shift * tower.arm.along;
    for (Local& p : all)
      p.v -= shift;
  }
  std::set<int> slices;
  for (const Local& p : all)
    if (p.z >= low && p.z < high &&
        std::max(std::abs(p.u), std::abs(p.v)) <=
            body_search + body_flare * std::max(0.0, tower.lowest_arm - p.z))
      slices.insert(static_cast<int>((p.z - low) / slice));
  const double fill = static_cast<double>(slices.size()) /
                      std::max(1.0, std::floor((high - low) / slice));
  double inside = 0, around = 0;
  for (const Local& p : all) {
    if (p.z < (low + high) / 2 || p.z > high || std::abs(p.u) > body_search)
      continue;
    inside += std::abs(p.v) <= body_search;
    around += std::abs(p.v) >= ring_from && std::abs(p.v) <= ring_to;
  }
  tower.seen = fill >= filled && inside / (2 * body_search) >=
                                     contrast * around / (2 * (ring_to - ring_from));
  if (!tower.seen)
    return;
  fitBody(tower, all);
  // Upward from the highest wire as long as points follow.
  std::vector<double> heights;
  for (const Local& p : all)
    if (p.z > tower.top && std::abs(p.v) < body_search &&
        std::abs(p.u) < tower.reach + 1)
      heights.push_back(p.z);
  std::sort(heights.begin(), heights.end());
  for (const double z : heights)
    if (z < tower.top + 2.5)
      tower.top = z;
}

bool
belongsTo(const Tower& tower, const std::vector<WireWithEnds>& wires, const Point& p)
{
  if (!tower.seen || p.z() > tower.top + 0.3)
    return false;
  const Local at = local(tower, p);
  if (tower.pole)
    return std::hypot(at.u, at.v) <= pole_radius + 0.2 ||
           (at.z > tower.lowest_arm - 1 && std::abs(at.v) < 0.6 &&
            std::abs(at.u) < tower.reach + 0.5);
  const double width =
      tower.half_width + tower.flare * std::max(0.0, tower.lowest_arm - at.z) + 0.4;
  if (std::max(std::abs(at.u), std::abs(at.v)) <= width)
    return true;
  if (at.z < tower.lowest_arm - arm_depth || std::abs(at.v) > std::max(width, 2.5))
    return false;
  double reach = 0;
  const Eigen::Vector2d across(-tower.arm.along.y(), tower.arm.along.x());
  for (const auto& [wire, side] : tower.ends) {
    const Point& end = wires[static_cast<std::size_t>(wire)]
                           .ends[static_cast<std::size_t>(side)]
                           .place;
    if (end.z() > at.z - 6 && end.z() < at.z + arm_depth)
      reach = std::max(reach, std::abs(across.dot(end.head<2>() - tower.arm.center)));
  }
  return std::abs(at.u) <= reach + arm_tip;
}

} // namespace linelet::powerline
