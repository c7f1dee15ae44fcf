// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "block_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <hwy/cache_control.h>

namespace linelet::grid {

namespace {

// A part is cut in two this many times.
constexpr int cuts = 3;

// Lists leave out, or sum up, what is certain by more than rounding.
constexpr double margin = 1e-5;

// It takes less time to weight fewer points for each query of a leaf than to sum all of
// their moments.
constexpr std::size_t worth_moments = 64;

constexpr double float_rounding = 0x1p-24;

} // namespace

BlockSweep::BlockSweep(const SweepJob& job)
    : job_(job),
      kernels_(sweepKernels()),
      gather_(job.frame, job.surface, job.radius),
      method_(sweepMethod(job.settings)),
      quadratic_(quadraticWeight(job.settings.weighting))
{
}

void
BlockSweep::operator()(std::size_t block)
{
  const BlockFrame::Cell cell = job_.frame.cell(job_.queries.key(block));
  origin_ = job_.frame.center(cell);
  reach_ = job_.frame.edge() / job_.radius / 2 + 1;
  first_ = job_.queries.begin(block);
  const std::size_t count = job_.queries.begin(block + 1) - first_;
  queries_.resize(count);
  radii_.resize(count);
  widths_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    // A record may lie in two cache lines.
    const PointDistributionTensor& record =
        job_.records[job_.queries.index(first_ + i)];
    hwy::Prefetch(&record.xx);
    hwy::Prefetch(&record.neighbors);
    queries_[i] = (job_.queries.point(first_ + i) - origin_) * (1 / job_.radius);
    radii_[i] = searchedRadiusOf(i) / job_.radius;
    widths_[i] = radiusOf(i) / job_.radius;
  }
  const auto makeRoom = [&](std::vector<double>& entries) {
    if (entries.size() < count + PointList::padding)
      entries.resize(count + PointList::padding);
  };
  std::for_each(sums_.begin(), sums_.end(), makeRoom);
  std::for_each(places_.begin(), places_.end(), makeRoom);
  makeRoom(found_);

  const double longest = *std::max_element(radii_.begin(), radii_.end());
  gather_(cell, origin_, queries_, longest + margin, region_);
  certain_.reserve(region_.size);
  certain_.size = 0;
  refineParts(0, count, cuts, region_, QuadraticMoments(), 0);
  if (method_ != SweepMethod::Double)
    write();
}

BlockSweep::Part
BlockSweep::part(std::size_t begin, std::size_t end) const
{
  Point low = queries_[begin], high = low;
  Part p{begin, end, low, 0, radii_[begin], radii_[begin], widths_[begin]};
  for (std::size_t i = begin + 1; i < end; ++i) {
    low = low.cwiseMin(queries_[i]);
    high = high.cwiseMax(queries_[i]);
    p.shortest = std::min(p.shortest, radii_[i]);
    p.longest = std::max(p.longest, radii_[i]);
    p.widest = std::max(p.widest, widths_[i]);
  }
  // As float: lists are made relative to it in float.
  p.center = ((low + high) / 2).cast<float>().cast<double>();
  double size = 0;
  for (std::size_t i = begin; i < end; ++i)
    size = std::max(size, (queries_[i] - p.center).squaredNorm());
  p.size = std::sqrt(size);
  return p;
}

void
BlockSweep::refine(const Part& queries,
                   const PointList& list,
                   const QuadraticMoments& inside,
                   std::size_t depth)
{
  if (stopped())
    return;
  const double near = queries.shortest - queries.size - margin;
  const double from = job_.weight.table.from;
  const double tabled =
      from > 0 ? std::sqrt(from) * queries.widest + queries.size + margin : 0;
  const double far = queries.longest + queries.size + margin;
  const Ball ball{toFloat(queries.center),
                  static_cast<float>(near > 0 ? near * near : -1.0),
                  static_cast<float>(far * far),
                  static_cast<float>(tabled * tabled)};
  const bool last = queries.end - queries.begin <= BlockOrder::leaf;
  if (!last && levels_.size() <= depth)
    levels_.emplace_back();
  PointList& kept = last ? last_ : levels_[depth];
  kept.reserve(list.size);
  const std::size_t known = certain_.size;
  QuadraticMoments all;
  if (method_ == SweepMethod::Weights) {
    kernels_.split(list, ball, last, kept, certain_);
    if (quadratic_ && certain_.size >= known + worth_moments) {
      kernels_.quadraticMoments(certain_, known, ball.center, all);
      all = all.relativeTo(-queries.center);
      certain_.size = known;
    }
    all += inside;
  }
  else {
    const bool sums = method_ == SweepMethod::Sums;
    kernels_.classify(list, ball, last, kept, sums ? &all.one : nullptr);
    all.one = all.one.relativeTo(-queries.center);
    all.one += inside.one;
  }
  if (last)
    solve(queries, all);
  else
    refineParts(queries.begin, queries.end, cuts, kept, all, depth + 1);
  certain_.size = known;
}

void
BlockSweep::refineParts(std::size_t begin,
                        std::size_t end,
                        int cuts_left,
                        const PointList& list,
                        const QuadraticMoments& inside,
                        std::size_t depth)
{
  if (cuts_left == 0 || end - begin <= BlockOrder::leaf) {
    refine(part(begin, end), list, inside, depth);
    return;
  }
  const std::size_t middle = begin + BlockOrder::half(end - begin);
  refineParts(begin, middle, cuts_left - 1, list, inside, depth);
  refineParts(middle, end, cuts_left - 1, list, inside, depth);
}

void
BlockSweep::solve(const Part& queries, const QuadraticMoments& inside)
{
  switch (method_) {
  case SweepMethod::Sums:
    sumConst(queries, inside.one.relativeTo(queries.center));
    break;
  case SweepMethod::Weights:
    for (std::size_t query = queries.begin; query < queries.end; ++query)
      sumWeighted(queries, query, inside);
    break;
  case SweepMethod::Center:
    for (std::size_t query = queries.begin; query < queries.end; ++query)
      sumCentered(queries, query);
    break;
  case SweepMethod::Double:
    for (std::size_t query = queries.begin; query < queries.end && !stopped(); ++query)
      job_.records[job_.queries.index(first_ + query)] = inDouble(query, last_);
    break;
  }
}

void
BlockSweep::sumConst(const Part& queries, const Moments& inside)
{
  std::array<BandedQuery, BlockOrder::leaf> around{};
  std::array<Moments, BlockOrder::leaf> sums;
  sums.fill(inside);
  const std::size_t count = queries.end - queries.begin;
  for (std::size_t i = 0; i < count; ++i)
    around[i] = banded(queries, queries.begin + i);
  const std::uint32_t doubts =
      kernels_.constSums(last_, around.data(), count, sums.data());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t query = queries.begin + i;
    if ((doubts >> i & 1) != 0)
      for (const Index place : decide(query, around[i]))
        sums[i].add(1, {last_.x[place], last_.y[place], last_.z[place]});
    keep(query, sums[i], queries_[query] - queries.center, sums[i].count);
  }
}

void
BlockSweep::sumWeighted(const Part& queries,
                        std::size_t query,
                        const QuadraticMoments& inside)
{
  const BandedQuery around = banded(queries, query);
  const auto scale = static_cast<float>(1 / (widths_[query] * widths_[query]));
  Moments t;
  const Found found = kernels_.weightedSums(
      {last_, around, certain_, toFloat(queries_[query])}, job_.weight, scale, t);
  auto neighbors = static_cast<double>(found.certain);
  if (found.doubtful)
    for (const Index place : decide(query, around)) {
      const Point offset(double{last_.x[place]} - double{around.at[0]},
                         double{last_.y[place]} - double{around.at[1]},
                         double{last_.z[place]} - double{around.at[2]});
      // A weight may end in a step on the ball: no other distance will do.
      const double distance = std::sqrt(squaredDistance(query, last_.id[place]));
      t.add(job_.settings.weighting(distance * (1 / radiusOf(query))), offset);
      ++neighbors;
    }
  if (quadratic_) {
    const Point& at = queries_[query];
    t += inside.weighted(quadratic_->a, quadratic_->b * scale, at).relativeTo(at);
    neighbors += inside.one.count;
  }
  keep(query, t, Point::Zero(), neighbors);
}

void
BlockSweep::sumCentered(const Part& queries, std::size_t query)
{
  const BandedQuery around = banded(queries, query);
  dense_.reserve(last_.size);
  if (kernels_.neighbors(last_, around, dense_)) {
    for (const Index place : decide(query, around)) {
      dense_.x[dense_.size] = last_.x[place] - around.at[0];
      dense_.y[dense_.size] = last_.y[place] - around.at[1];
      dense_.z[dense_.size] = last_.z[place] - around.at[2];
      ++dense_.size;
    }
    dense_.pad();
  }
  const auto scale = static_cast<float>(1 / (widths_[query] * widths_[query]));
  Moments reference, t;
  kernels_.momentsAround(dense_,
                         {0, 0, 0},
                         job_.settings.centroid == Centroid::WeightedMean
                             ? job_.settings.centroid_weighting
                             : Weighting(Kernel::Const),
                         scale,
                         reference);
  // Without weight there is no reference, and sums of 0 are not precise.
  if (reference.count > 1e-3)
    kernels_.momentsAround(dense_,
                           toFloat(reference.first / reference.count),
                           job_.settings.weighting,
                           scale,
                           t);
  keep(query, t, Point::Zero(), static_cast<double>(dense_.size));
}

void
BlockSweep::keep(std::size_t query,
                 const Moments& sums,
                 const Point& at,
                 double neighbors)
{
  const std::array<double, 10> values = {sums.count,
                                         sums.first.x(),
                                         sums.first.y(),
                                         sums.first.z(),
                                         sums.xx,
                                         sums.xy,
                                         sums.xz,
                                         sums.yy,
                                         sums.yz,
                                         sums.zz};
  for (std::size_t m = 0; m < values.size(); ++m)
    sums_[m][query] = values[m];
  for (std::size_t axis = 0; axis < 3; ++axis)
    places_[axis][query] = at[static_cast<Eigen::Index>(axis)];
  found_[query] = neighbors;
}

bool
BlockSweep::stopped() const
{
  if (job_.monitor != nullptr && job_.monitor->canceled())
    job_.stop = true;
  return job_.stop;
}

double
BlockSweep::radiusOf(std::size_t query) const
{
  return job_.radii != nullptr ? (*job_.radii)[job_.queries.index(first_ + query)]
                               : job_.settings.radius;
}

double
BlockSweep::searchedRadiusOf(std::size_t query) const
{
  return std::min(radiusOf(query), job_.reach);
}

double
BlockSweep::squaredDistance(std::size_t query, std::uint32_t sorted_index) const
{
  return (job_.surface.point(sorted_index) - job_.queries.point(first_ + query))
      .squaredNorm();
}

bool
BlockSweep::isNeighbor(std::size_t query, std::uint32_t sorted_index) const
{
  const double radius = searchedRadiusOf(query);
  return squaredDistance(query, sorted_index) <= radius * radius;
}

const Indices&
BlockSweep::decide(std::size_t query, const BandedQuery& around)
{
  doubtful_.clear();
  kernels_.inBand(last_, around, method_ == SweepMethod::Sums, doubtful_);
  const auto out = [&](Index place) { return !isNeighbor(query, last_.id[place]); };
  doubtful_.erase(std::remove_if(doubtful_.begin(), doubtful_.end(), out),
                  doubtful_.end());
  return doubtful_;
}

BandedQuery
BlockSweep::banded(const Part& queries, std::size_t query) const
{
  // Rounded in the same steps as points of the list, so that a query that is one of
  // them is at distance 0 from itself.
  const Float3 q = toFloat(queries_[query]), c = toFloat(queries.center);
  // Rounding of a coordinate of the list and of the query, and of their differences to
  // the center; each changes the distance, which is about the radius.
  const double radius = radii_[query];
  const double far = queries.longest + queries.size;
  const double coordinates = std::sqrt(3.0) * (2 * reach_ + far + queries.size);
  // Rounding of |p|^2 (three steps) and of the three steps to |p - q|^2 from it.
  const double steps = 3 * far * far + 3 * (far * far + 2 * far * queries.size);
  const double error = float_rounding * 1.25 * (2 * radius * coordinates + steps + 2);
  const double squared = radius * radius;
  return {{q[0] - c[0], q[1] - c[1], q[2] - c[2]},
          {static_cast<float>(squared - error), static_cast<float>(squared + error)}};
}

} // namespace linelet::grid
