// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/find_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include <linelet/support/threads.h>

#include "powerline/plan_extent.h"
#include "support/parallel_failure.h"

namespace linelet::powerline {

namespace {

constexpr double cell_size = 2;
constexpr int largest_radius = 12; // cells: lowers buildings up to 50 m wide
// Steepest rise that an opening must leave alone: 45 degrees, at which scree comes to
// rest (angle of repose, 30 to 45 degrees by the size and edges of the grains).
constexpr double terrain_slope = 1;
constexpr double surface_part = 0.7; // of the usual share of a surface around terrain
// Of the surroundings of the usual cell, what is a surface where there is one at all.
constexpr double least_surface = 0.5;
constexpr double pi = 3.14159265358979323846;
constexpr double step = 0.3; // height noise, meters
constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

struct Raster {
  Ground ground;

  std::size_t
  cellOf(const Point& p) const
  {
    const auto place = [](double offset, double cell, int count) {
      return static_cast<std::size_t>(
          std::clamp(std::floor(offset / cell + 0.5), 0.0, count - 1.0));
    };
    return place(p.y() - ground.y, ground.cell, ground.rows) *
               static_cast<std::size_t>(ground.columns) +
           place(p.x() - ground.x, ground.cell, ground.columns);
  }
};

Raster
emptyRaster(const PlanExtent& extent)
{
  Raster raster;
  if (extent.points == 0)
    return raster;
  Ground& g = raster.ground;
  const double most = 4.0 * static_cast<double>(extent.points) + 1e6;
  for (g.cell = cell_size; extent.cells(g.cell) > most; g.cell *= 2) {
  }
  const Eigen::Vector2d corner = rasterCorner(extent.low, g.cell);
  const Eigen::Vector2d size = extent.high - corner;
  g.columns = static_cast<int>(size.x() / g.cell) + 1;
  g.rows = static_cast<int>(size.y() / g.cell) + 1;
  g.x = corner.x() + g.cell / 2;
  g.y = corner.y() + g.cell / 2;
  g.heights.assign(
      static_cast<std::size_t>(g.columns) * static_cast<std::size_t>(g.rows), unknown);
  return raster;
}

// How much of the quarter of its surroundings that fits a cell best shows a surface on
// which it lies: cells with returns, as high as terrain can be there.
float
surfaceAround(const Ground& g, int column, int row)
{
  constexpr int angles = 16, quarter = angles / 4 + 1;
  constexpr std::array<int, 4> radii = {
      largest_radius / 4, largest_radius / 2, 3 * largest_radius / 4, largest_radius};
  const auto at = [&](int c, int r) {
    return g.heights[static_cast<std::size_t>(r) * static_cast<std::size_t>(g.columns) +
                     static_cast<std::size_t>(c)];
  };
  const float height = at(column, row);
  std::array<int, angles> fits{};
  for (int k = 0; k < angles; ++k)
    for (const int radius : radii) {
      const double angle = k * 2 * pi / angles;
      const int c = column + static_cast<int>(std::lround(radius * std::cos(angle)));
      const int r = row + static_cast<int>(std::lround(radius * std::sin(angle)));
      if (c < 0 || r < 0 || c >= g.columns || r >= g.rows)
        continue;
      // NaN where there is no return: never near.
      if (std::abs(at(c, r) - height) <= step + terrain_slope * g.cell * radius)
        ++fits[static_cast<std::size_t>(k)];
    }
  int best = 0;
  for (int k = 0; k < angles; ++k) {
    int sum = 0;
    for (int more = 0; more < quarter; ++more)
      sum += fits[static_cast<std::size_t>((k + more) % angles)];
    best = std::max(best, sum);
  }
  return static_cast<float>(best) / static_cast<float>(quarter * radii.size());
}

// Of every cell with a return.
std::vector<float>
surfacesAround(const Ground& ground, unsigned threads)
{
  std::vector<float> share(ground.heights.size(), unknown);
  const auto cells = static_cast<std::ptrdiff_t>(share.size());
#pragma omp parallel for schedule(static) num_threads(threadCount(threads))
  for (std::ptrdiff_t i = 0; i < cells; ++i)
    if (!std::isnan(ground.heights[static_cast<std::size_t>(i)]))
      share[static_cast<std::size_t>(i)] =
          surfaceAround(ground,
                        static_cast<int>(i % ground.columns),
                        static_cast<int>(i / ground.columns));
  return share;
}

// Returns that lie on no surface are no terrain: over water, which sends nothing back,
// they are the wires. Wires side by side take each other for one: from their edges on,
// they are forgotten by and by.
void
forgetLines(Ground& ground, unsigned threads, const ProgressMonitor* monitor)
{
  std::vector<float> share = surfacesAround(ground, threads), usual;
  std::copy_if(share.begin(), share.end(), std::back_inserter(usual), [](float s) {
    return !std::isnan(s);
  });
  if (usual.empty())
    return;
  const auto middle = usual.begin() + static_cast<std::ptrdiff_t>(usual.size() / 2);
  std::nth_element(usual.begin(), middle, usual.end());
  if (static_cast<double>(*middle) < least_surface)
    return; // a pylon and its wires, as a drone sees them
  const auto least = static_cast<float>(surface_part) * *middle;
  for (bool any = true; any; share = surfacesAround(ground, threads)) {
    throwIfCanceled(monitor);
    any = false;
    for (std::size_t i = 0; i < share.size(); ++i)
      if (share[i] < least) {
        ground.heights[i] = unknown;
        any = true;
      }
  }
}

// Lifts cells far below all but one of their neighbors: multipath returns.
void
repairPits(std::vector<float>& heights, int columns, int rows)
{
  const std::vector<float> old = heights;
  const auto at = [columns](int c, int r) {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(c);
  };
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      std::array<float, 24> around;
      std::size_t count = 0;
      for (int y = std::max(0, r - 2); y <= std::min(rows - 1, r + 2); ++y)
        for (int x = std::max(0, c - 2); x <= std::min(columns - 1, c + 2); ++x)
          if (x != c || y != r)
            around[count++] = old[at(x, y)];
      if (count < 5)
        continue;
      std::nth_element(around.begin(), around.begin() + 3, around.begin() + count);
      if (old[at(c, r)] < around[3] - 2.5F)
        heights[at(c, r)] = around[3];
    }
}

// Sliding minimum (or maximum, by sign) along one line of cells, any radius, O(length).
void
slide(
    const float* in, float* out, int count, std::size_t stride, int radius, float sign)
{
  std::vector<int> queue(static_cast<std::size_t>(count));
  std::size_t head = 0, tail = 0;
  const auto value = [&](int i) {
    return sign * in[static_cast<std::size_t>(i) * stride];
  };
  for (int i = 0, next = 0; i < count; ++i) {
    for (; next < count && next <= i + radius; ++next) {
      while (tail > head && value(queue[tail - 1]) >= value(next))
        --tail;
      queue[tail++] = next;
    }
    while (queue[head] < i - radius)
      ++head;
    out[static_cast<std::size_t>(i) * stride] = sign * value(queue[head]);
  }
}

std::vector<float>
filtered(const std::vector<float>& raster,
         int columns,
         int rows,
         int radius,
         float sign,
         unsigned threads)
{
  std::vector<float> half(raster.size()), out(raster.size());
  const auto width = static_cast<std::size_t>(columns);
  ParallelFailure failure;
#pragma omp parallel num_threads(threadCount(threads))
  {
#pragma omp for schedule(static)
    for (int r = 0; r < rows; ++r)
      failure.guard([&] {
        const std::size_t begin = static_cast<std::size_t>(r) * width;
        slide(&raster[begin], &half[begin], columns, 1, radius, sign);
      });
#pragma omp for schedule(static)
    for (std::size_t c = 0; c < width; ++c)
      failure.guard([&] { slide(&half[c], &out[c], rows, width, radius, sign); });
  }
  failure.rethrow();
  return out;
}

// Where a point lies beside the surface, and how far above its cell.
struct Offset {
  std::size_t cell = none;
  float above = 0;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

Offset
offsetFrom(const Raster& raster, const Point& p)
{
  const Ground& g = raster.ground;
  const double dx = std::abs(g.heightAt(p.x() + g.cell / 2, p.y()) -
                             g.heightAt(p.x() - g.cell / 2, p.y()));
  const double dy = std::abs(g.heightAt(p.x(), p.y() + g.cell / 2) -
                             g.heightAt(p.x(), p.y() - g.cell / 2));
  const double above = p.z() - g.heightAt(p.x(), p.y());
  if (std::abs(above) > step + dx + dy)
    return {};
  const std::size_t cell = raster.cellOf(p);
  return {cell, static_cast<float>(p.z()) - g.heights[cell]};
}

// The mean height of the points beside the surface: cells' minima lie too low on
// slopes.
void
refine(Raster& raster, const PlanExtent& extent, const Points& points, unsigned threads)
{
  Ground& g = raster.ground;
  std::vector<float> sum(g.heights.size(), 0.0F);
  std::vector<std::uint32_t> count(g.heights.size(), 0);
  // Summed up in the order of the points, so that threads change nothing.
  std::vector<Offset> offsets(std::min<std::size_t>(points.size(), 1 << 18));
  for (std::size_t first = 0; first < points.size(); first += offsets.size()) {
    const std::size_t number = std::min(offsets.size(), points.size() - first);
#pragma omp parallel for schedule(static) num_threads(threadCount(threads))
    for (std::size_t k = 0; k < number; ++k) {
      const Point& p = points[first + k];
      offsets[k] =
          p.allFinite() && extent.contains(p) ? offsetFrom(raster, p) : Offset();
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

} // namespace

std::vector<float>
openRaster(const std::vector<float>& raster,
           int columns,
           int rows,
           int radius,
           unsigned threads)
{
  return filtered(filtered(raster, columns, rows, radius, 1, threads),
                  columns,
                  rows,
                  radius,
                  -1,
                  threads);
}

void
fillHoles(std::vector<float>& raster,
          int columns,
          int rows,
          Fill fill,
          std::int64_t first_column,
          std::int64_t first_row)
{
  if (std::none_of(
          raster.begin(), raster.end(), [](float v) { return std::isnan(v); }) ||
      std::all_of(raster.begin(), raster.end(), [](float v) { return std::isnan(v); }))
    return;
  // Pairs begin at even places, wherever the raster begins.
  const int odd_column = columns > 2 ? static_cast<int>(first_column & 1) : 0,
            odd_row = rows > 2 ? static_cast<int>(first_row & 1) : 0;
  const int half_columns = (columns + odd_column + 1) / 2,
            half_rows = (rows + odd_row + 1) / 2;
  const auto width = static_cast<std::size_t>(columns);
  const auto half_width = static_cast<std::size_t>(half_columns);
  std::vector<float> coarse(half_width * static_cast<std::size_t>(half_rows), 0.0F);
  std::vector<int> count(coarse.size(), 0);
  for (std::size_t i = 0; i < raster.size(); ++i)
    if (!std::isnan(raster[i])) {
      const std::size_t c =
          (i / width + static_cast<std::size_t>(odd_row)) / 2 * half_width +
          (i % width + static_cast<std::size_t>(odd_column)) / 2;
      if (fill == Fill::Smooth)
        coarse[c] += raster[i];
      else if (count[c] == 0 || raster[i] < coarse[c])
        coarse[c] = raster[i];
      ++count[c];
    }
  for (std::size_t i = 0; i < coarse.size(); ++i)
    if (count[i] == 0)
      coarse[i] = unknown;
    else if (fill == Fill::Smooth)
      coarse[i] /= static_cast<float>(count[i]);
  fillHoles(coarse,
            half_columns,
            half_rows,
            fill,
            (first_column - odd_column) / 2,
            (first_row - odd_row) / 2);
  Ground surface;
  surface.cell = 2;
  surface.x = 0.5 - odd_column;
  surface.y = 0.5 - odd_row;
  surface.columns = half_columns;
  surface.rows = half_rows;
  surface.heights = std::move(coarse);
  for (std::size_t i = 0; i < raster.size(); ++i)
    if (std::isnan(raster[i]))
      raster[i] = static_cast<float>(surface.heightAt(static_cast<double>(i % width),
                                                      static_cast<double>(i / width)));
}

Ground
findGround(const Points& points,
           const std::vector<std::uint8_t>& classes,
           bool use_classes,
           const ProgressMonitor* monitor,
           bool on_surfaces,
           unsigned threads)
{
  const PlanExtent extent = planExtent(points, cell_size);
  throwIfCanceled(monitor);
  Raster raster = emptyRaster(extent);
  Ground& g = raster.ground;
  if (g.heights.empty())
    return g;
  const auto fill = [&](std::vector<float>& heights, Fill how) {
    fillHoles(heights,
              g.columns,
              g.rows,
              how,
              std::llround(g.x / g.cell),
              std::llround(g.y / g.cell));
  };

  if (use_classes && std::count(classes.begin(), classes.end(), 2) >= 3) {
    Points terrain;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (classes[i] == 2 && points[i].allFinite() && extent.contains(points[i]))
        terrain.push_back(points[i]);
    for (const Point& p : terrain) {
      float& height = g.heights[raster.cellOf(p)];
      height = std::fmin(height, static_cast<float>(p.z()));
    }
    fill(g.heights, Fill::Smooth);
    refine(raster, extent, terrain, threads);
    return g;
  }

  for (const Point& p : points)
    if (p.allFinite() && extent.contains(p)) {
      float& height = g.heights[raster.cellOf(p)];
      height = std::fmin(height, static_cast<float>(p.z()));
    }
  if (on_surfaces)
    forgetLines(g, threads, monitor);
  // Where nothing was seen the terrain may be low: what hangs above it must stand out.
  throwIfCanceled(monitor);
  std::vector<float> surface = g.heights;
  fill(surface, Fill::Low);
  repairPits(surface, g.columns, g.rows);
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (!std::isnan(g.heights[i]))
      g.heights[i] = surface[i];
  for (int radius = 1; radius <= largest_radius; ++radius) {
    throwIfCanceled(monitor);
    const std::vector<float> opened =
        openRaster(surface, g.columns, g.rows, radius, threads);
    // Terrain of the steepest slope loses this much more than at the radius before.
    const float limit = static_cast<float>(step + terrain_slope * g.cell);
    for (std::size_t i = 0; i < surface.size(); ++i)
      if (surface[i] > opened[i] + limit)
        g.heights[i] = unknown;
    surface = opened;
  }
  fill(g.heights, Fill::Smooth);
  throwIfCanceled(monitor);
  refine(raster, extent, points, threads);
  return g;
}

} // namespace linelet::powerline
