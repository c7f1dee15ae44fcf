// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/terrain/refine_ground.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <linelet/support/threads.h>

#include "powerline/terrain/ground_raster.h"

namespace linelet::powerline {

namespace {

// The cell of a point next to the surface, and its height above it.
struct Offset {
  std::size_t cell = none;
  float above = 0;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

Offset
offsetFrom(const Ground& g, const Point& p)
{
  const double dx = std::abs(g.heightAt(p.x() + g.cell / 2, p.y()) -
                             g.heightAt(p.x() - g.cell / 2, p.y()));
  const double dy = std::abs(g.heightAt(p.x(), p.y() + g.cell / 2) -
                             g.heightAt(p.x(), p.y() - g.cell / 2));
  const double above = p.z() - g.heightAt(p.x(), p.y());
  if (std::abs(above) > terrain_noise + dx + dy)
    return {};
  const std::size_t cell = cellOf(g, p);
  return {cell, static_cast<float>(p.z()) - g.heights[cell]};
}

} // namespace

void
refineGround(Ground& g,
             const PlanExtent& extent,
             const Points& points,
             unsigned threads)
{
  std::vector<float> sum(g.heights.size(), 0.0F);
  std::vector<std::uint32_t> count(g.heights.size(), 0);
  // Summed in point order, so that threads do not affect the result.
  std::vector<Offset> offsets(std::min<std::size_t>(points.size(), 1 << 18));
  for (std::size_t first = 0; first < points.size(); first += offsets.size()) {
    const std::size_t number = std::min(offsets.size(), points.size() - first);
#pragma omp parallel for schedule(static) num_threads(threadCount(threads))
    for (std::size_t k = 0; k < number; ++k) {
      const Point& p = points[first + k];
      offsets[k] = p.allFinite() && extent.contains(p) ? offsetFrom(g, p) : Offset();
    }
    for (std::size_t k = 0; k < number; ++k)
      if (const auto& [cell, above] = offsets[k]; cell != Offset::none) {
        sum[cell] += above;
        ++count[cell];
      }
  }
  for (std::size_t i = 0; i < sum.size(); ++i)
    if (count[i] > 0)
      g.heights[i] += sum[i] / static_cast<float>(count[i]);
}

} // namespace linelet::powerline
