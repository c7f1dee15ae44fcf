// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/false_positives/false_positives.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include <Eigen/Dense>

#include "powerline/line_priors.h"
#include "powerline/pieces/bend.h"
#include "powerline/pieces/candidates.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/parallel.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

namespace {

constexpr double part_of = 0.5;    // of the length beside something straight
constexpr double part_reach = 2.5; // meters from it

constexpr double highest_fence = 9;  // meters
constexpr double fence_half = 0.35;  // meters beside its top rail
constexpr double beside_from = 0.6;  // meters beside it, where nothing is ...
constexpr double beside_to = 1.6;    // ... that is not there everywhere
constexpr double fence_bin = 2;      // meters along
constexpr double fence_slice = 1;    // meters of height
constexpr double grass = 0.5;        // meters
constexpr double fence_filled = 0.5; // of its bins and slices
constexpr double fence_contrast = 2; // filled there to filled beside
constexpr double plan_cell = 2;      // meters

constexpr double longest_arm = 45;    // meters, both sides of a pylon
constexpr double arm_reach = 4;       // meters, of a wire's end from the crossarm
constexpr double most_parallel = 0.5; // cosine of crossarm and wire
constexpr double arm_part = 0.4;      // of its length, over which the ends spread
constexpr int carried = 2;            // wires that a crossarm holds at least

constexpr double ledge_from = 0.25; // meters beside a railing, where the roof ...
constexpr double ledge_to = 1.8;    // ... that it stands on ...
constexpr double ledge_low = 2.2;   // ... lies at most this far below ...
constexpr double ledge_high = 0.3;  // ... or above it
constexpr double ledge_flat = 0.1;  // meters off its plane, of most points ...
constexpr double ledge_part = 0.7;  // ... this part of them
constexpr double ledge_cover = 0.8; // of the bins along the railing

struct Cells {
  std::set<std::pair<int, int>> within, beside;
};

std::uint64_t
cellOf(double x, double y)
{
  const auto part = [](double v) {
    return static_cast<std::uint64_t>(
        static_cast<std::int64_t>(std::floor(v / plan_cell)) & 0xFFFFFFFF);
  };
  return part(x) << 32 | part(y);
}

// Which wires are the top of a fence: the space below them is filled nearly everywhere
// down to the ground, unlike beside them.
std::vector<char>
findFences(const std::vector<WireWithEnds>& wires,
           const Points& points,
           const Ground& ground)
{
  std::vector<char> fence(wires.size(), 0);
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> near;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    const SpanModel& m = wires[w].model();
    const Point middle = m.at((m.begin + m.end) / 2);
    if (!(middle.z() - ground.heightAt(middle.x(), middle.y()) < highest_fence))
      continue;
    for (double s = m.begin; s <= m.end; s += plan_cell / 2)
      for (const double t : {-beside_to, 0.0, beside_to}) {
        const Point p = m.at(s);
        auto& cell =
            near[cellOf(p.x() - t * m.direction.y(), p.y() + t * m.direction.x())];
        if (cell.empty() || cell.back() != w)
          cell.push_back(w);
      }
  }
  if (near.empty())
    return fence;
  std::vector<Cells> filled(wires.size());
  for (const Point& p : points) {
    const auto cell = p.allFinite() ? near.find(cellOf(p.x(), p.y())) : near.end();
    if (cell == near.end() || p.z() < ground.heightAt(p.x(), p.y()) + grass)
      continue;
    for (const std::size_t w : cell->second) {
      const SpanModel& m = wires[w].model();
      const double s = m.along(p);
      const double off = std::abs(m.residual(p, s)[0]);
      const double drop = m.height(s) - p.z();
      if (s < m.begin || s > m.end || drop < grass || off > beside_to ||
          (off > fence_half && off < beside_from))
        continue;
      (off <= fence_half ? filled[w].within : filled[w].beside)
          .emplace(static_cast<int>((s - m.begin) / fence_bin),
                   static_cast<int>((drop - grass) / fence_slice));
    }
  }
  for (std::size_t w = 0; w < wires.size(); ++w) {
    if (filled[w].within.empty())
      continue;
    const SpanModel& m = wires[w].model();
    double all = 0;
    for (double s = m.begin + fence_bin / 2; s < m.end; s += fence_bin) {
      const Point p = m.at(s);
      all += std::max(1.0,
                      std::floor((p.z() - ground.heightAt(p.x(), p.y()) - 2 * grass) /
                                 fence_slice));
    }
    const double within = static_cast<double>(filled[w].within.size());
    const double beside = static_cast<double>(filled[w].beside.size());
    fence[w] = within >= fence_filled * all && within >= fence_contrast * beside;
  }
  return fence;
}

// Whether a piece is the railing or edge of a roof: a plane begins beside it, at about
// its height, over its whole length.
bool
isLedge(const Growth& growth, const Piece& piece)
{
  const SpanModel& m = piece.model;
  const Candidates& candidates = growth.candidates();
  const int bins = std::max(1, static_cast<int>(m.length() / bin_length));
  const double step = m.length() / bins;
  Points beside[2]; // along, across, above the wire; to its left and right
  std::set<int> hit[2];
  for (int k = 0; k < bins; ++k) {
    const double from = m.begin + k * step;
    const Point below = m.at(from + step / 2) - ledge_low / 2 * Point::UnitZ();
    const double reach =
        std::hypot(step / 2, std::hypot(ledge_to, ledge_low / 2 + 0.3));
    candidates.grid.forEachWithin(below, reach, [&](Index i, double) {
      const Point& p = candidates.points[i];
      const double s = m.along(p);
      const double t = m.residual(p, s)[0];
      const double rise = p.z() - m.height(s);
      if (growth.owner(i) != Growth::nobody || s < from || s >= from + step ||
          std::abs(t) < ledge_from || std::abs(t) > ledge_to || rise < -ledge_low ||
          rise > ledge_high)
        return;
      beside[t > 0].emplace_back(s - m.begin, t, rise);
      hit[t > 0].insert(k);
    });
  }
  for (int side = 0; side < 2; ++side) {
    const Points& points = beside[side];
    if (static_cast<double>(hit[side].size()) < ledge_cover * bins ||
        static_cast<double>(points.size()) < m.length())
      continue;
    // A plane with robust weights: rise = c0 + c1 s + c2 t.
    Eigen::Vector3d plane = Eigen::Vector3d::Zero();
    for (int iteration = 0; iteration < 6; ++iteration) {
      Eigen::Matrix3d normal = 1e-6 * Eigen::Matrix3d::Identity();
      Eigen::Vector3d right = Eigen::Vector3d::Zero();
      for (const Point& p : points) {
        const Eigen::Vector3d x(1, p.x(), p.y());
        const double off = iteration == 0 ? 0 : p.z() - plane.dot(x);
        const double w = 1 / (1 + std::pow(off / ledge_flat, 2));
        normal += w * x * x.transpose();
        right += w * p.z() * x;
      }
      plane = normal.ldlt().solve(right);
    }
    const auto flat = std::count_if(points.begin(), points.end(), [&](const Point& p) {
      return std::abs(p.z() - plane.dot(Eigen::Vector3d(1, p.x(), p.y()))) < ledge_flat;
    });
    if (static_cast<double>(flat) >= ledge_part * static_cast<double>(points.size()))
      return true;
  }
  return false;
}

// Whether a wire is a crossarm: short, and longer wires end at it from the side.
bool
isCrossarm(const std::vector<WireWithEnds>& wires, std::size_t candidate)
{
  const SpanModel& m = wires[candidate].model();
  if (m.length() > longest_arm)
    return false;
  int held = 0;
  double low = m.end, high = m.begin;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    const SpanModel& other = wires[w].model();
    if (w == candidate || other.length() < m.length() ||
        std::abs(m.direction.dot(other.direction)) > most_parallel)
      continue;
    for (int side = 0; side < 2; ++side) {
      const Point end = other.at(wires[w].edge(side));
      const double s = std::clamp(m.along(end), m.begin, m.end);
      if ((m.at(s) - end).norm() > arm_reach)
        continue;
      ++held;
      low = std::min(low, s);
      high = std::max(high, s);
    }
  }
  // Where a line branches off, others end at one end of its wires.
  return held >= carried && high - low >= arm_part * m.length();
}

// Whether a wire runs into the ground at one end, as guys do.
bool
isGuy(const WireWithEnds& wire, const Ground& ground, double lowest)
{
  const SpanModel& m = wire.model();
  for (int side = 0; side < 2; ++side) {
    const auto height = [&](double on) {
      const Point p = m.at(wire.edge(side) + (side == 0 ? -on : on));
      return p.z() - ground.heightAt(p.x(), p.y());
    };
    const double fall = height(0) - height(1); // per meter
    if (fall >= priors.guy_slope && height(0) <= lowest + priors.guy_reach * fall)
      return true;
  }
  return false;
}

} // namespace

void
dropFalsePositives(std::vector<WireWithEnds>& wires,
                   Growth& growth,
                   const Points& points,
                   const Ground& ground,
                   double min_height)
{
  std::vector<char> wrong = findFences(wires, points, ground);
  for (std::size_t w = 0; w < wires.size(); ++w) {
    const Piece& piece = wires[w].strand.piece;
    wrong[w] = wrong[w] != 0 || isLedge(growth, piece) || isCrossarm(wires, w) ||
               isGuy(wires[w], ground, min_height) ||
               (piece.model.length() >= straight_length &&
                bendOf(piece, growth.candidates().points).rulesOut(flattest));
  }
  // What runs along such a thing, and is not clearly bent, is part of it.
  const std::vector<char> alone = wrong;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    const SpanModel& m = wires[w].model();
    for (std::size_t x = 0; x < wires.size() && wrong[w] == 0; ++x) {
      if (alone[x] == 0)
        continue;
      const Parallel parallel = compare(m, wires[x].model());
      wrong[w] =
          parallel.overlap >= part_of * m.length() && parallel.distance <= part_reach &&
          !bendOf(wires[w].strand.piece, growth.candidates().points).isAbove(flattest);
    }
  }
  std::vector<WireWithEnds> kept;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    if (wrong[w] == 0) {
      kept.push_back(std::move(wires[w]));
      continue;
    }
    release(wires[w], growth);
  }
  wires = std::move(kept);
}

} // namespace linelet::powerline
