// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/fragments/tiling.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace linelet::fragments {

namespace {

/** The points of \a inputs that are expected within \a ghost of \a box; those that
 * reach there are put into \a near. */
double
expected(const Area& box,
         double ghost,
         const std::vector<Extent>& inputs,
         std::vector<Extent>& near)
{
  double points = 0;
  for (const Extent& input : inputs) {
    double share = 1;
    for (std::size_t a = 0; a < 2; ++a) {
      const double from = std::max(input.area.low[a], box.low[a] - ghost);
      const double to = std::min(input.area.high[a], box.high[a] + ghost);
      const double side = input.area.high[a] - input.area.low[a];
      share *= to < from ? 0 : side > 0 ? (to - from) / side : 1;
    }
    if (share <= 0)
      continue;
    near.push_back(input);
    points += share * input.points;
  }
  return points;
}

/** The least number of slices of \a box across \a axis that hold the most points each
 * with their ghost zones, if its \a points are spread evenly over what is \a near; 2
 * where none is enough. */
double
slicesOf(const Area& box,
         std::size_t axis,
         const std::vector<Extent>& near,
         double points,
         const TilingSettings& settings)
{
  double low = box.high[axis], high = box.low[axis];
  for (const Extent& input : near) {
    low = std::min(low, input.area.low[axis]);
    high = std::max(high, input.area.high[axis]);
  }
  const double filled = std::min(high, box.high[axis] + settings.ghost) -
                        std::max(low, box.low[axis] - settings.ghost);
  const double side = box.high[axis] - box.low[axis];
  const double slice = settings.most_points / points * filled - 2 * settings.ghost;
  return slice > 2 * settings.ghost && slice < side ? std::ceil(side / slice) : 2;
}

/** Where to cut \a low to \a high into two parts of whole \a slices: about half way, on
 * a multiple of \a chunk if one lies within. */
double
planeBetween(double low, double high, double slices, double chunk)
{
  const double about = low + (high - low) * std::floor(slices / 2) / slices;
  if (!(chunk > 0))
    return about;
  const double plane = std::round(about / chunk) * chunk;
  return plane > low && plane < high ? plane : about;
}

} // namespace

Tiling::Tiling(std::vector<Cut> cuts) : cuts_(std::move(cuts))
{
  for (const Cut& cut : cuts_)
    for (const int side : {cut.below, cut.above})
      if (side >= static_cast<int>(cuts_.size()) ||
          side < -1 - static_cast<int>(cuts_.size()) || cut.axis < 0 || cut.axis > 1)
        throw std::invalid_argument("these cuts are not a tiling");
}

Tiling::Tiling(const std::vector<Extent>& inputs, const TilingSettings& settings)
{
  for (const double number : {settings.ghost, settings.chunk, settings.most_points})
    if (!(number >= 0) || !std::isfinite(number))
      throw std::invalid_argument(
          "lengths and numbers of points must be finite and not negative");
  constexpr double none = std::numeric_limits<double>::infinity();
  Area all{{none, none}, {-none, -none}};
  for (const Extent& input : inputs)
    for (std::size_t a = 0; a < 2; ++a) {
      all.low[a] = std::min(all.low[a], input.area.low[a]);
      all.high[a] = std::max(all.high[a], input.area.high[a]);
    }
  int boxes = 0;
  if (!inputs.empty())
    cut(all, inputs, settings, boxes);
}

int
Tiling::cut(const Area& box,
            const std::vector<Extent>& inputs,
            const TilingSettings& settings,
            int& boxes)
{
  std::vector<Extent> near;
  const double points = expected(box, settings.ghost, inputs, near);
  const double sides[2] = {box.high[0] - box.low[0], box.high[1] - box.low[1]};
  const std::size_t axis = sides[1] > sides[0] ? 1 : 0;
  const bool crowded = settings.most_points > 0 && points > settings.most_points &&
                       sides[axis] > std::max(4 * settings.ghost, 0.0);
  // A border of the data may lie on one of the boxes.
  const bool wide =
      settings.chunk > 0 && !near.empty() && sides[axis] > settings.chunk * (1 + 1e-9);
  const double slices =
      crowded && !wide ? slicesOf(box, axis, near, points, settings) : 2;
  const double plane = planeBetween(
      box.low[axis], box.high[axis], slices, wide || crowded ? settings.chunk : 0);
  if (!(crowded || wide) || !(plane > box.low[axis] && plane < box.high[axis]))
    return -1 - boxes++;
  const std::size_t number = cuts_.size();
  cuts_.push_back({static_cast<int>(axis), plane, 0, 0});
  Area below = box, above = box;
  below.high[axis] = above.low[axis] = plane;
  const int one = cut(below, near, settings, boxes);
  const int other = cut(above, near, settings, boxes);
  cuts_[number].below = one;
  cuts_[number].above = other;
  return static_cast<int>(number);
}

std::size_t
Tiling::owner(double x, double y) const
{
  int node = cuts_.empty() ? -1 : 0;
  while (node >= 0) {
    const Cut& cut = cuts_[static_cast<std::size_t>(node)];
    node = (cut.axis == 0 ? x : y) < cut.plane ? cut.below : cut.above;
  }
  return static_cast<std::size_t>(-1 - node);
}

Area
Tiling::box(std::size_t number) const
{
  constexpr double none = std::numeric_limits<double>::infinity();
  Area area{{-none, -none}, {none, none}};
  // From the box up to the root of all cuts.
  for (int inside = -1 - static_cast<int>(number); inside != 0 && !cuts_.empty();) {
    std::size_t k = 0;
    while (k < cuts_.size() && cuts_[k].below != inside && cuts_[k].above != inside)
      ++k;
    if (k == cuts_.size())
      throw std::out_of_range("not a box of this tiling");
    const Cut& cut = cuts_[k];
    const auto a = static_cast<std::size_t>(cut.axis);
    if (cut.below == inside)
      area.high[a] = std::min(area.high[a], cut.plane);
    else
      area.low[a] = std::max(area.low[a], cut.plane);
    inside = static_cast<int>(k);
  }
  return area;
}

std::vector<std::size_t>
Tiling::near(const Area& area, double ghost) const
{
  std::vector<std::size_t> found;
  if (cuts_.empty())
    return {0};
  std::vector<int> nodes = {0};
  while (!nodes.empty()) {
    const int node = nodes.back();
    nodes.pop_back();
    if (node < 0) {
      found.push_back(static_cast<std::size_t>(-1 - node));
      continue;
    }
    const Cut& cut = cuts_[static_cast<std::size_t>(node)];
    const auto a = static_cast<std::size_t>(cut.axis);
    if (area.low[a] < cut.plane + ghost)
      nodes.push_back(cut.below);
    if (area.high[a] >= cut.plane - ghost)
      nodes.push_back(cut.above);
  }
  std::sort(found.begin(), found.end());
  return found;
}

} // namespace linelet::fragments
