// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/curve_blocks.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "curves/cloud_kind.h"
#include "whole_as_part.h"

namespace linelet {

namespace {

// In D: the longest side of a block, and the margin around it. The shape of a point
// needs 17 of it, the evidence of a curve the rest.
constexpr double longest_side = 400, margin = 50;
// In D: curves of two blocks are the same within this distance.
constexpr double same_curve = 0.5;

} // namespace

CurveBlocks::CurveBlocks(const CloudTraits& whole)
{
  const bool is_one = isSmall(whole) || isOfCurvesAlone(whole) || !hasScale(whole);
  for (std::size_t a = 0; a < 2; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    low_[a] = whole.low[axis];
    sides_[a] = std::max(0.0, whole.high[axis] - whole.low[axis]);
    if (is_one)
      continue;
    const double number =
        std::max(1.0, std::ceil(sides_[a] / (longest_side * whole.scale_unit)));
    numbers_[a] = static_cast<std::size_t>(number);
    sides_[a] /= number;
  }
  if (count() > 1)
    margin_ = margin * whole.scale_unit;
}

std::size_t
CurveBlocks::owner(const Point& p) const
{
  std::array<std::size_t, 2> place{};
  for (std::size_t a = 0; a < 2; ++a) {
    const auto last = static_cast<double>(numbers_[a] - 1);
    const double steps =
        last > 0 ? (p[static_cast<Eigen::Index>(a)] - low_[a]) / sides_[a] : 0;
    place[a] = static_cast<std::size_t>(std::clamp(std::floor(steps), 0.0, last));
  }
  return place[1] * numbers_[0] + place[0];
}

Point
CurveBlocks::middle(std::size_t block) const
{
  const auto along = [&](std::size_t axis, std::size_t place) {
    return low_[axis] + (static_cast<double>(place) + 0.5) * sides_[axis];
  };
  return {along(0, block % numbers_[0]), along(1, block / numbers_[0]), 0};
}

bool
CurveBlocks::takesPart(const Point& p, std::size_t block) const
{
  if (count() == 1)
    return true;
  const Point off = (p - middle(block)).cwiseAbs();
  return off.x() <= sides_[0] / 2 + margin_ && off.y() <= sides_[1] / 2 + margin_;
}

std::vector<std::size_t>
CurveBlocks::around(const Point& p) const
{
  std::vector<std::size_t> blocks;
  if (!p.allFinite())
    return blocks;
  // Blocks are wider than margins, so only adjacent ones can be near.
  const std::size_t own = owner(p), column = own % numbers_[0], row = own / numbers_[0];
  const auto next = [this](std::size_t axis, std::size_t place) {
    return std::min(place + 1, numbers_[axis] - 1);
  };
  const auto last = [](std::size_t place) { return place - (place > 0 ? 1 : 0); };
  for (std::size_t y = last(row); y <= next(1, row); ++y)
    for (std::size_t x = last(column); x <= next(0, column); ++x)
      if (takesPart(p, y * numbers_[0] + x))
        blocks.push_back(y * numbers_[0] + x);
  return blocks;
}

double
CurveBlocks::reach() const
{
  constexpr double rounding = 1e-6;
  return (1 + rounding) * (std::max(sides_[0], sides_[1]) / 2 + margin_);
}

CurveNetwork
joinBlocks(std::vector<CurvePart> parts, const CloudTraits& whole)
{
  return joinParts(std::move(parts), same_curve * whole.scale_unit);
}

CurveNetwork
inOrderOfPlaces(const CurveNetwork& found)
{
  return joinParts({wholeAsPart(found)}, 0);
}

} // namespace linelet
