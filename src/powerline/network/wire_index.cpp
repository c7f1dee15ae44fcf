// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/network/wire_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linelet::powerline {

namespace {

constexpr double cell_size = 64;   // meters
constexpr double sigmas = 5;       // by which both may be apart
constexpr double least_apart = .1; // meters, the same
constexpr double end_apart = 2;    // meters beyond an end

/** Largest distance of \a wire from \a other, at its middle and on both sides of it;
 * infinite unless it lies on \a other. */
double
distanceOf(const Wire& wire, const Wire& other)
{
  double farthest = 0;
  for (const double part : {0.25, 0.5, 0.75}) {
    const Point p =
        wire.curve.at(wire.curve.from + part * (wire.curve.to - wire.curve.from));
    const double s = other.curve.along(p);
    if (s < other.curve.from - end_apart || s > other.curve.to + end_apart)
      return std::numeric_limits<double>::infinity();
    farthest = std::max(farthest, other.curve.distance(p));
  }
  return farthest;
}

} // namespace

WireIndex::Cell
WireIndex::cellOf(const Point& p)
{
  return {static_cast<std::int64_t>(std::floor(p.x() / cell_size)),
          static_cast<std::int64_t>(std::floor(p.y() / cell_size))};
}

int
WireIndex::add(const Wire& wire)
{
  const int number = static_cast<int>(wires_.size());
  wires_.push_back(wire);
  const double length = wire.curve.to - wire.curve.from;
  const int steps = static_cast<int>(length / (cell_size / 2)) + 1;
  for (int k = 0; k <= steps; ++k) {
    const auto [x, y] = cellOf(wire.curve.at(wire.curve.from + length * k / steps));
    for (std::int64_t i = -1; i <= 1; ++i)
      for (std::int64_t j = -1; j <= 1; ++j) {
        std::vector<int>& there = cells_[{x + i, y + j}];
        if (there.empty() || there.back() != number)
          there.push_back(number);
      }
  }
  return number;
}

int
WireIndex::find(const Wire& wire) const
{
  const auto cell = cells_.find(cellOf(middleOf(wire)));
  if (cell == cells_.end())
    return none;
  int best = none;
  double least = std::numeric_limits<double>::infinity();
  for (const int number : cell->second) {
    const Wire& other = (*this)[number];
    const double far = distanceOf(wire, other);
    if (far < least && far <= std::max(least_apart, sigmas * (wire.rms + other.rms))) {
      least = far;
      best = number;
    }
  }
  return best;
}

} // namespace linelet::powerline
