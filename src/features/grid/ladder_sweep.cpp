// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ladder_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace linelet::grid {

namespace {

// Lists leave out, or sum up, what is certain by more than rounding.
constexpr double margin = 1e-5;

// Radii below need coordinates with more digits than those relative to the block.
constexpr double sharp_radius = 0.125;

// Parts of the block, and parts of a part: cut in two so many times.
constexpr int first_cuts = 4, cuts = 3;

} // namespace

LadderSweep::LadderSweep(const LadderJob& job, LeafVisitor visit)
    : job_(job),
      lists_(sweepKernels()),
      kernels_(ladderKernels()),
      gather_(job.frame, job.surface, job.radii.back()),
      visit_(std::move(visit)),
      method_(sweepMethod(job.settings)),
      weight_(job.settings.weighting),
      centre_weight_(job.settings.centroid == Centroid::WeightedMean
                         ? job.settings.centroid_weighting
                         : Weighting(Kernel::Const)),
      weight_error_(weightError(job.settings.weighting)),
      scales_(job.radii.size()),
      certain_(job.radii.size()),
      open_(job.radii.size()),
      ends_(job.radii.size()),
      sums_(job.radii.size()),
      centre_sums_(job.radii.size()),
      shapes_(job.radii.size()),
      sweep_(job.radii, job.settings)
{
  core_.reserve(0);
  for (std::size_t k = 0; k < job.radii.size(); ++k) {
    certain_[k].reserve(0);
    open_[k].reserve(0);
  }
  for (const double radius : job.radii)
    radii_.push_back(radius / job.radii.back());
}

void
LadderSweep::operator()(const LadderPiece& piece)
{
  const BlockFrame::Cell cell = job_.frame.cell(job_.queries.key(piece.block));
  const double unit = job_.radii.back();
  origin_ = job_.frame.center(cell);
  reach_ = job_.frame.edge() / unit / 2 + 1;
  first_ = piece.begin;
  const std::size_t count = piece.end - piece.begin;
  queries_.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    queries_[i] = (job_.queries.point(first_ + i) - origin_) * (1 / unit);
  gather_(cell, origin_, queries_, 1 + margin, region_);
  refine(0, count, region_, 0, first_cuts);
}

LadderSweep::Part
LadderSweep::part(std::size_t begin, std::size_t end) const
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
LadderSweep::refine(std::size_t begin,
                    std::size_t end,
                    const PointList& list,
                    std::size_t depth,
                    int cuts_left)
{
  if (end - begin <= leaf_queries) {
    solve(part(begin, end), list, depth);
    return;
  }
  if (cuts_left == 0) {
    const PointList& shrunk = shrink(part(begin, end), list, depth);
    refine(begin, end, shrunk, depth + 1, cuts);
    return;
  }
  const std::size_t middle = begin + BlockOrder::half(end - begin);
  refine(begin, middle, list, depth, cuts_left - 1);
  refine(middle, end, list, depth, cuts_left - 1);
}

const PointList&
LadderSweep::shrink(const Part& queries, const PointList& list, std::size_t depth)
{
  if (levels_.size() <= depth) {
    levels_.emplace_back();
    inside_.emplace_back(radii_.size());
  }
  PointList& kept = levels_[depth];
  kept.reserve(list.size);
  if (method_ != SweepMethod::Sums) {
    const double far = 1 + queries.size + margin;
    const Ball ball{toFloat(queries.center), -1, static_cast<float>(far * far)};
    lists_.classify(list, ball, false, kept, nullptr);
    return kept;
  }
  setScales(queries, false);
  for (PointList& shell : certain_)
    shell.size = 0;
  const double core = queries.size + margin;
  kernels_.splitNode(list,
                     toFloat(queries.center),
                     static_cast<float>(core * core),
                     scales_.data(),
                     scales_.size(),
                     certain_.data(),
                     kept);
  Moments sum;
  for (std::size_t k = 0; k < radii_.size(); ++k) {
    if (certain_[k].size > 0)
      kernels_.addMoments(certain_[k], sum);
    inside_[depth][k] = sum.relativeTo(-queries.center);
    if (depth > 0)
      inside_[depth][k] += inside_[depth - 1][k];
  }
  return kept;
}

double
LadderSweep::coordinateError(std::size_t scale, double size) const
{
  // Candidates and queries are rounded relative to the center of the leaf, candidates
  // far away relative to the block as well.
  const double far = radii_[scale] + size;
  return float_rounding * (far + size + radii_[scale] +
                           (radii_[scale] < sharp_radius ? 0 : reach_ + far));
}

void
LadderSweep::setScales(const Part& queries, bool leaf)
{
  const double size = queries.size;
  for (std::size_t k = 0; k < radii_.size(); ++k) {
    const double radius = radii_[k], near = radius - size - margin,
                 far = radius + size + margin;
    LadderScale& scale = scales_[k];
    scale.radius = static_cast<float>(radius);
    // A coordinate of a part that is no leaf has no more digits than the block gives.
    const bool inner = near > 0 && (leaf || radius >= sharp_radius);
    scale.relative = radius < 1.5 * size;
    scale.near = inner && !scale.relative ? static_cast<float>(near * near) : -1.0F;
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
LadderSweep::solve(const Part& queries, const PointList& list, std::size_t depth)
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
  setScales(queries, true);
  redo_ = 0;
  if (method_ == SweepMethod::Double)
    redo_ = (1U << leaf_queries) - 1;
  else {
    const double far = 1 + queries.size + margin,
                 sharp = sharp_radius + queries.size + 2 * margin;
    leaf_.reserve(list.size);
    lists_.classify(list,
                    {toFloat(queries.center), -1, static_cast<float>(far * far)},
                    true,
                    leaf_,
                    nullptr);
    const double core = queries.size + margin;
    core_.size = 0;
    kernels_.sharpen(leaf_,
                     static_cast<float>(sharp * sharp),
                     {job_.surface.coordinate(0),
                      job_.surface.coordinate(1),
                      job_.surface.coordinate(2),
                      {origin_.x(), origin_.y(), origin_.z()},
                      1 / job_.radii.back(),
                      {queries.center.x(), queries.center.y(), queries.center.z()}},
                     static_cast<float>(core * core),
                     core_);
    core_.pad();
    countHere(queries);
    doubts_.clear();
    std::fill(sums_.begin(), sums_.end(), LadderSums());
    if (method_ == SweepMethod::Sums)
      sums(queries, depth);
    else {
      kernels_.order(leaf_, spare_, scales_.data(), scales_.size(), ends_.data());
      method_ == SweepMethod::Weights ? weights(queries) : centred(queries);
    }
  }
  for (std::size_t lane = 0; lane < count; ++lane)
    if ((redo_ >> lane & 1) != 0)
      inDouble(queries.begin, lane);
  visit_(shapes_);
}

} // namespace linelet::grid
