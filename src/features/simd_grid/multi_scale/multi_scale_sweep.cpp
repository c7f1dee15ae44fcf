// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "multi_scale_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace linelet::grid {

namespace {

// Radii below need coordinates with more digits than those relative to the block.
constexpr double sharp_radius = 0.125;

// A part is cut in two this many times.
constexpr int cuts = 2;

constexpr auto no_block = std::numeric_limits<std::size_t>::max();

} // namespace

MultiScaleSweep::MultiScaleSweep(const MultiScaleJob& job, LeafVisitor visit)
    : job_(job),
      kernels_(multiScaleKernels()),
      around_(job.frame, job.surface),
      visit_(std::move(visit)),
      method_(sweepMethod(job.settings)),
      weight_(job.settings.weighting),
      center_weight_(job.settings.centroid == Centroid::WeightedMean
                         ? job.settings.centroid_weighting
                         : Weighting(Kernel::Const)),
      weight_error_(weightError(job.settings.weighting)),
      reaches_{0},
      block_(no_block),
      places_{job.surface, {}, {}, {}},
      scales_(job.radii.size()),
      ends_(job.radii.size()),
      sums_(job.radii.size()),
      center_sums_(job.radii.size()),
      shapes_(job.radii.size()),
      sweep_(job.radii, job.settings)
{
  for (const double radius : job.radii)
    radii_.push_back(radius / job.unit);
  for (const double radius : radii_)
    searched_.push_back(std::min(radius, 1.0));
  if (method_ == SweepMethod::Sums)
    reaches_.insert(reaches_.end(), searched_.begin(), searched_.end());
  else
    reaches_.push_back(searched_.back());
}

void
MultiScaleSweep::operator()(const MultiScalePiece& piece)
{
  if (piece.block != block_)
    gather(piece.block);
  first_ = piece.begin;
  const std::size_t count = piece.end - piece.begin;
  queries_.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    queries_[i] = (job_.queries.point(first_ + i) - origin_) * (1 / job_.unit);
  refine(0, count, 0, 0);
}

void
MultiScaleSweep::gather(std::size_t block)
{
  block_ = block;
  const BlockFrame::Cell cell = job_.frame.cell(job_.queries.key(block));
  origin_ = job_.frame.center(cell);
  reach_ = job_.frame.edge() / 2 / job_.unit;
  const auto runs = around_(cell);
  std::size_t count = 0;
  for (const auto& [first, last] : runs)
    count += job_.groups.begin(last) - job_.groups.begin(first);
  region_.reserve(count);
  region_.size = 0;
  places_.begin.resize(count);
  places_.size.resize(count);
  places_.points.reserve(count * PointGroups::most_points);
  group_sums_.resize(count);
  certain_.resize(count + PointList::padding);
  for (const auto& [first, last] : runs)
    for (std::size_t i = job_.groups.begin(first); i < job_.groups.begin(last); ++i)
      addGroup(job_.groups[i]);
}

void
MultiScaleSweep::addGroup(const PointGroup& group)
{
  const double scale = 1 / job_.unit;
  const Point center = (group.center - origin_) * scale;
  const Float3 rounded = toFloat(center);
  const std::size_t at = region_.size++;
  region_.x[at] = rounded[0];
  region_.y[at] = rounded[1];
  region_.z[at] = rounded[2];
  region_.h[at] = static_cast<float>(group.radius * scale);
  region_.id[at] = static_cast<std::uint32_t>(at);
  places_.begin[at] = group.begin;
  places_.size[at] = group.size;
  kernels_.placeGroup(places_, at, {{}, origin_, scale, 0});
  if (method_ == SweepMethod::Sums) {
    Moments about = group.about;
    about *= scale * scale;
    about.first *= scale;
    group_sums_[at] = about.relativeTo(-center);
  }
}

MultiScaleSweep::Part
MultiScaleSweep::part(std::size_t begin, std::size_t end) const
{
  Point low = queries_[begin], high = low;
  for (std::size_t i = begin + 1; i < end; ++i) {
    low = low.cwiseMin(queries_[i]);
    high = high.cwiseMax(queries_[i]);
  }
  // As float: lists are made relative to it in float.
  const Point center = ((low + high) / 2).cast<float>().cast<double>();
  double size = 0;
  for (std::size_t i = begin; i < end; ++i)
    size = std::max(size, (queries_[i] - center).squaredNorm());
  return {begin, end, center, std::sqrt(size)};
}

void
MultiScaleSweep::refine(std::size_t begin,
                        std::size_t end,
                        std::size_t depth,
                        int cuts_left)
{
  if (job_.monitor != nullptr && job_.monitor->canceled())
    job_.stop = true;
  if (job_.stop)
    return;
  const bool leaf = end - begin <= leaf_queries;
  if (!leaf && cuts_left > 0) {
    const std::size_t middle = begin + BlockOrder::half(end - begin);
    refine(begin, middle, depth, cuts_left - 1);
    refine(middle, end, depth, cuts_left - 1);
    return;
  }
  const Part queries = part(begin, end);
  shrink(queries, depth);
  if (leaf)
    solve(queries, levels_[depth]);
  else
    refine(begin, end, depth + 1, cuts);
}

void
MultiScaleSweep::shrink(const Part& queries, std::size_t depth)
{
  if (levels_.size() <= depth) {
    levels_.emplace_back();
    levels_.back().open.resize(reaches_.size());
    levels_.back().inside.resize(reaches_.size());
  }
  Level& level = levels_[depth];
  for (std::size_t i = 0; i < reaches_.size(); ++i) {
    const PointList& groups = depth > 0 ? levels_[depth - 1].open[i] : region_;
    const double near = reaches_[i] - queries.size - margin,
                 far = reaches_[i] + queries.size + margin;
    level.open[i].reserve(groups.size);
    const std::size_t certain = kernels_.splitGroups(
        groups,
        toFloat(queries.center),
        static_cast<float>(method_ == SweepMethod::Sums ? near : -1.0),
        static_cast<float>(far),
        level.open[i],
        certain_.data());
    Moments inside;
    if (depth > 0)
      inside = levels_[depth - 1].inside[i];
    for (std::size_t g = 0; g < certain; ++g)
      inside += group_sums_[certain_[g]];
    level.inside[i] = inside;
  }
}

void
MultiScaleSweep::open(const Part& queries,
                      const PointList& groups,
                      float near,
                      float far,
                      PointList& list,
                      Moments& certain)
{
  list.reserve(groups.size * PointGroups::most_points);
  const double unit = job_.unit, sharp = sharp_radius + queries.size + 2 * margin;
  kernels_.openGroups(groups,
                      places_,
                      {toFloat(queries.center),
                       origin_ + queries.center * unit,
                       1 / unit,
                       static_cast<float>(sharp * sharp)},
                      near,
                      far,
                      list,
                      certain);
}

double
MultiScaleSweep::coordinateError(std::size_t scale, double size) const
{
  // Candidates and queries are rounded relative to the center of the leaf, candidates
  // of the larger scales relative to the block as well.
  const double far = searched_[scale] + size;
  return float_rounding *
         (far + size + (searched_[scale] < sharp_radius ? 0 : reach_ + far));
}

void
MultiScaleSweep::setScales(const Part& queries, const Level& level)
{
  const double size = queries.size;
  for (std::size_t k = 0; k < radii_.size(); ++k) {
    const double radius = searched_[k], near = radius - size - margin,
                 far = radius + size + margin;
    LeafScale& scale = scales_[k];
    scale.radius = static_cast<float>(radii_[k]);
    // Sums of groups are not relative to the query.
    const bool summed = method_ == SweepMethod::Sums && level.inside[k + 1].count > 0;
    scale.relative = !summed && radius < 1.5 * size;
    scale.near = near > 0 && !scale.relative ? static_cast<float>(near * near) : -1.0F;
    scale.far = static_cast<float>(far * far);
    // Rounding of coordinates, each of which changes the distance, and of the steps to
    // |p|^2 and from it to |p - q|^2.
    const double steps = float_rounding * (6 * far * far + 6 * far * size +
                                           2 * size * size + 2 * radius * radius);
    const double error =
        1.25 * (2 * std::sqrt(3.0) * radius * coordinateError(k, size) + steps);
    const double squared = radius * radius;
    scale.band = {static_cast<float>((squared - error) * (1 - float_rounding)),
                  static_cast<float>((squared + error) * (1 + float_rounding))};
  }
}

void
MultiScaleSweep::solve(const Part& queries, const Level& level)
{
  const std::size_t count = queries.end - queries.begin;
  shapes_.count = count;
  for (std::size_t lane = 0; lane < leaf_queries; ++lane) {
    const std::size_t query = queries.begin + std::min(lane, count - 1);
    shapes_.query[lane] = job_.queries.index(first_ + query);
    const Point at = queries_[query] - queries.center;
    const Float3 rounded = toFloat(at);
    at_.x[lane] = rounded[0];
    at_.y[lane] = rounded[1];
    at_.z[lane] = rounded[2];
    for (std::size_t axis = 0; axis < 3; ++axis)
      exact_at_[axis][lane] = at[static_cast<Eigen::Index>(axis)];
  }
  setScales(queries, level);
  redo_.fill(method_ == SweepMethod::Double ? radii_.size() : 0);
  if (method_ != SweepMethod::Double) {
    Moments none;
    const double core = queries.size + margin;
    open(queries, level.open[0], -1, static_cast<float>(core * core), core_, none);
    countHere(queries);
    doubts_.clear();
    std::fill(sums_.begin(), sums_.end(), ScaleSums());
    if (method_ == SweepMethod::Sums)
      sums(queries, level);
    else {
      open(queries, level.open[1], -1, scales_.back().far, leaf_, none);
      kernels_.order(leaf_, spare_, scales_.data(), scales_.size(), ends_.data());
      method_ == SweepMethod::Weights ? weights(queries) : centered(queries);
    }
  }
  for (std::size_t lane = 0; lane < count; ++lane)
    if (redo_[lane] > 0)
      inDouble(queries.begin, lane, redo_[lane]);
  visit_(shapes_);
}

} // namespace linelet::grid
