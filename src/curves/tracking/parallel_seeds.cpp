// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "parallel_seeds.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "curve_frames.h"
#include "support/parallel_chunks.h"

namespace linelet {

namespace {

// Of the known curve, on a stretch: enough for a parallel one to show, few enough to be
// nearly straight.
constexpr double stretch_points = 30;
constexpr double parallel_reach = 7; // D, across
// Side of the cells of the cross-section, in standard deviations of the known curve's
// points. A block of cells is compared with the ring around it.
constexpr double cell_size = 1.5;
constexpr int block = 1, ring = 3; // cells on either side of the middle one
constexpr int block_cells = (2 * block + 1) * (2 * block + 1);
constexpr int ring_cells = (2 * ring + 1) * (2 * ring + 1) - block_cells;
constexpr int fewest_in_block = 5; // points

/** \brief A straight stretch along which points are projected. */
struct Stretch {
  Point middle, direction, first, second; ///< a place, and the axes of its frame
  double half = 0;                        ///< of its length
  double noise = 0;                       ///< of the curve
};

/** \brief Stretches of \a curve, overlapping by half. */
std::vector<Stretch>
stretchesOf(const ModelCurve& curve, double spacing, double least_noise)
{
  std::vector<Stretch> result;
  const CurveFrames frames = framesOf(curve);
  const double whole = length(curve);
  const double size = std::min(whole, stretch_points * spacing);
  const double step = whole / std::max(1.0, std::round(2 * whole / size));
  double begin = 0, next = step / 2;
  for (std::size_t e = 0; e < curve.edges(); ++e) {
    const Point way = curve.to(e) - curve.from(e);
    const Point direction = way.normalized();
    for (; next <= begin + way.norm(); next += step)
      result.push_back({curve.from(e) + (next - begin) * direction,
                        direction,
                        frames.first[e],
                        frames.second[e],
                        size / 2,
                        std::max(curve.noise, least_noise)});
    begin += way.norm();
  }
  return result;
}

/** \brief Adds stretches beyond both ends of \a curve, each in all the directions that
 * the curve has: those of a wire come again in the next span. */
void
addStretchesBeyond(const ModelCurve& curve, double reach, std::vector<Stretch>& all)
{
  if (curve.closed || all.empty())
    return;
  const Stretch model = all.front();
  Points directions;
  for (const Stretch& s : all)
    if (std::none_of(directions.begin(), directions.end(), [&](const Point& d) {
          return (d - s.direction).norm() * model.half < cell_size * model.noise;
        }))
      directions.push_back(s.direction);
  const Point &front = curve.nodes.front(), &back = curve.nodes.back();
  const Point chord = (back - front).normalized();
  for (double on = model.half / 2; on < reach; on += model.half)
    for (const Point& middle : {Point(front - on * chord), Point(back + on * chord)})
      for (const Point& d : directions) {
        const Point first = d.unitOrthogonal();
        all.push_back({middle, d, first, d.cross(first), model.half, model.noise});
      }
}

/** \brief Numbers of points in the cells of a cross-section. */
class CellCounts {
public:
  void
  reset(double reach, double side)
  {
    side_ = side;
    cells_ = 2 * (static_cast<int>(std::ceil(reach / side)) + ring) + 1;
    counts_.assign(static_cast<std::size_t>(cells_ * cells_), 0);
  }

  int
  cells() const
  {
    return cells_;
  }

  int
  cellOf(const Eigen::Vector2d& offset) const
  {
    const auto along = [&](double x) {
      return static_cast<int>(std::floor(x / side_ + 0.5 * cells_));
    };
    return along(offset.x()) * cells_ + along(offset.y());
  }

  /** \brief Rows or columns between two cells, whichever are more. */
  int
  apart(int a, int b) const
  {
    return std::max(std::abs(a / cells_ - b / cells_),
                    std::abs(a % cells_ - b % cells_));
  }

  void
  add(int cell)
  {
    ++counts_[static_cast<std::size_t>(cell)];
  }

  /** \brief Points in the cells up to \a around from \a cell, in both directions. */
  int
  around(int cell, int around) const
  {
    int sum = 0;
    for (int x = -around; x <= around; ++x) {
      const auto row = counts_.begin() + cell + x * cells_;
      sum = std::accumulate(row - around, row + around + 1, sum);
    }
    return sum;
  }

private:
  double side_ = 0;
  int cells_ = 0;
  std::vector<int> counts_;
};

/** \brief A point beside a stretch. */
struct Beside {
  Eigen::Vector2d offset;
  double along;
  Index index;
  int cell;
};

/** \brief The points beside \a stretch that neither a surface nor a curve explains. */
std::vector<Beside>
pointsBeside(const TrackedScene& scene, const Stretch& stretch, double reach)
{
  std::vector<Beside> result;
  scene.grid.forEachRun(
      stretch.middle,
      std::hypot(stretch.half, reach),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Point v = scene.points()[i] - stretch.middle;
          const double along = stretch.direction.dot(v);
          if (std::abs(along) > stretch.half || scene.taken[i] || scene.surface[i])
            continue;
          const Eigen::Vector2d offset(stretch.first.dot(v), stretch.second.dot(v));
          if (offset.squaredNorm() <= reach * reach)
            result.push_back({offset, along, static_cast<Index>(i), 0});
        }
      });
  return result;
}

/** \brief The seed in the block of cells about \a cell. */
TrackSeed
seedIn(int cell,
       const Stretch& stretch,
       const std::vector<Beside>& points,
       const CellCounts& counts)
{
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double squares = 0, members = 0;
  const Beside* middle = nullptr;
  for (const Beside& p : points) {
    if (counts.apart(p.cell, cell) > block)
      continue;
    sum += p.offset;
    squares += p.offset.squaredNorm();
    members += 1;
    if (middle == nullptr || std::abs(p.along) < std::abs(middle->along))
      middle = &p;
  }
  const Eigen::Vector2d mean = sum / members;
  TrackSeed seed;
  seed.index = middle->index;
  seed.at = stretch.middle + mean.x() * stretch.first + mean.y() * stretch.second;
  seed.direction = stretch.direction;
  seed.radius = stretch.half;
  seed.density = members / (2 * stretch.half);
  seed.noise = std::sqrt(std::max(0.0, squares / members - mean.squaredNorm()) / 2);
  return seed;
}

void
addSeeds(const TrackedScene& scene,
         const Stretch& stretch,
         std::size_t stretches,
         CellCounts& counts,
         std::vector<TrackSeed>& seeds)
{
  const double reach = parallel_reach * scene.unit;
  std::vector<Beside> points = pointsBeside(scene, stretch, reach);
  if (points.size() < fewest_in_block)
    return;
  counts.reset(reach, cell_size * stretch.noise);
  std::vector<int> cells;
  for (Beside& p : points) {
    p.cell = counts.cellOf(p.offset);
    counts.add(p.cell);
    cells.push_back(p.cell);
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  // What the best of so many blocks along the curve would show by chance.
  const double needed =
      2 * std::log(double(counts.cells())) + std::log(double(stretches));
  std::vector<std::pair<double, int>> best; // evidence, cell
  for (const int cell : cells) {
    const int members = counts.around(cell, block);
    if (members < fewest_in_block)
      continue;
    const double beside = 1 + counts.around(cell, ring) - members;
    const double expected = beside * block_cells / ring_cells;
    const double evidence = members * std::log(members / expected) - members + expected;
    if (evidence > needed)
      best.emplace_back(evidence, cell);
  }
  std::sort(best.begin(), best.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  std::vector<int> chosen;
  for (const auto& [evidence, cell] : best) {
    // Blocks that overlap a better one are of the same curve.
    if (std::any_of(chosen.begin(), chosen.end(), [&, c = cell](int other) {
          return counts.apart(c, other) <= 2 * block;
        }))
      continue;
    chosen.push_back(cell);
    seeds.push_back(seedIn(cell, stretch, points, counts));
    seeds.back().quality = evidence - needed;
  }
}

} // namespace

std::vector<TrackSeed>
seedsAlongCurves(const TrackedScene& scene,
                 const ModelCurves& curves,
                 double beyond,
                 unsigned threads,
                 ProgressMonitor* monitor)
{
  if (monitor)
    monitor->begin("parallel curves", curves.size());
  std::vector<std::vector<TrackSeed>> of_curve(curves.size());
  forEachChunk(curves.size(), 1, threads, [&](std::size_t c, std::size_t) {
    if (monitor && monitor->canceled())
      throw Canceled();
    const ModelCurve& curve = curves[c];
    const double count = std::accumulate(curve.counts.begin(), curve.counts.end(), 0.0);
    const double whole = length(curve);
    if (!(whole > 0) || !(count > 0))
      return;
    const double spacing = whole / count;
    std::vector<Stretch> stretches =
        stretchesOf(curve, spacing, least_track_noise * scene.unit);
    addStretchesBeyond(curve, beyond * spacing, stretches);
    CellCounts counts;
    for (const Stretch& stretch : stretches)
      addSeeds(scene, stretch, stretches.size(), counts, of_curve[c]);
  });
  if (monitor)
    monitor->advance(curves.size());
  std::vector<TrackSeed> seeds;
  for (const std::vector<TrackSeed>& some : of_curve)
    seeds.insert(seeds.end(), some.begin(), some.end());
  std::stable_sort(
      seeds.begin(), seeds.end(), [](const TrackSeed& a, const TrackSeed& b) {
        return a.quality > b.quality;
      });
  return seeds;
}

} // namespace linelet
