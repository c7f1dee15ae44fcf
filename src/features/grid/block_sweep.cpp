// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "block_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <hwy/cache_control.h>

namespace linelet::grid {

namespace {

// Parts of a part: cut in two so many times.
constexpr int cuts = 3;

// Lists leave out, or sum up, what is certain by more than rounding.
constexpr double margin = 1e-5;

constexpr double float_rounding = 0x1p-24;

} // namespace

BlockSweep::BlockSweep(const SweepJob& job)
    : job_(job),
      kernels_(sweepKernels()),
      gather_(job.frame, job.surface, job.radius),
      method_(sweepMethod(job.settings)),
      sums_(method_ == SweepMethod::Sums),
      weight_error_(weightError(job.settings.weighting))
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
  for (std::size_t i = 0; i < count; ++i) {
    // A record may lie in two cache lines.
    const PointDistributionTensor& record =
        job_.records[job_.queries.index(first_ + i)];
    hwy::Prefetch(&record.xx);
    hwy::Prefetch(&record.neighbors);
    queries_[i] = (job_.queries.point(first_ + i) - origin_) * (1 / job_.radius);
    radii_[i] = radiusOf(i) / job_.radius;
  }
  found_.assign(count, 0);
  known_.assign(count, 0);
  for (std::vector<double>& entries : tensors_)
    entries.assign(count + PointList::padding, 0.0);

  const double longest = *std::max_element(radii_.begin(), radii_.end());
  gather_(cell, origin_, queries_, longest + margin, region_);
  certain_.reserve(region_.size);
  certain_.size = 0;
  refine(part(0, count), region_, Moments(), 0);
  write();
}

BlockSweep::Part
BlockSweep::part(std::size_t begin, std::size_t end) const
{
  Point low = queries_[begin], high = low;
  Part p{begin, end, low, 0, radii_[begin], radii_[begin]};
  for (std::size_t i = begin + 1; i < end; ++i) {
    low = low.cwiseMin(queries_[i]);
    high = high.cwiseMax(queries_[i]);
    p.shortest = std::min(p.shortest, radii_[i]);
    p.longest = std::max(p.longest, radii_[i]);
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
                   const Moments& inside,
                   std::size_t depth)
{
  const double near = queries.shortest - queries.size - margin;
  const double tabled = std::sqrt(double{job_.weight.table.from}) * queries.longest +
                        queries.size + margin;
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
  Moments here;
  if (method_ == SweepMethod::Weights)
    kernels_.split(list, ball, last, kept, certain_);
  else
    kernels_.classify(list, ball, last, kept, sums_ ? &here : nullptr);
  Moments all = here.relativeTo(-queries.center);
  all += inside;
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
                        const Moments& inside,
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
BlockSweep::solve(const Part& queries, const Moments& inside)
{
  for (std::size_t query = queries.begin; query < queries.end; ++query)
    solveOne(queries, query, inside);
}

void
BlockSweep::solveOne(const Part& queries, std::size_t query, const Moments& inside)
{
  Moments t;
  bool good = false;
  switch (method_) {
  case SweepMethod::Sums:
    good = constTensor(queries, query, inside, t);
    break;
  case SweepMethod::Weights:
    good = weightedTensor(queries, query, t);
    break;
  case SweepMethod::Centre:
    good = centredTensor(queries, query, t);
    break;
  case SweepMethod::Double:
    break;
  }
  known_[query] = good;
  if (!good) {
    job_.records[job_.queries.index(first_ + query)] = inDouble(
        query,
        method_ == SweepMethod::Sums || method_ == SweepMethod::Weights ? region_
                                                                        : last_);
    return;
  }
  const double scale = 1 / t.count;
  const std::array<double, 6> entries = {t.xx, t.xy, t.xz, t.yy, t.yz, t.zz};
  for (std::size_t entry = 0; entry < 6; ++entry)
    tensors_[entry][query] = entries[entry] * scale;
}

bool
BlockSweep::constTensor(const Part& queries,
                        std::size_t query,
                        const Moments& inside,
                        Moments& t)
{
  const Float3 at = local(query, queries.center);
  const Band limits = band(queries, query);
  Moments sums;
  const Found found = kernels_.constSums(last_, at, limits, sums);
  if (found.doubtful)
    for (const Index place : decide(query, at, limits))
      sums.add(1, {last_.x[place], last_.y[place], last_.z[place]});
  // From the part to the query, exactly.
  t = sums.relativeTo(queries_[query] - queries.center);
  t += inside.relativeTo(queries_[query]);
  found_[query] = static_cast<std::uint32_t>(t.count);
  const double spread = t.trace();
  if (job_.settings.centroid == Centroid::Mean && t.count > 0)
    t = t.relativeTo(t.first / t.count);
  return precise(t, spread, found_[query]);
}

bool
BlockSweep::weightedTensor(const Part& queries, std::size_t query, Moments& t)
{
  const Float3 at = local(query, queries.center);
  const Band limits = band(queries, query);
  const auto scale = static_cast<float>(1 / (radii_[query] * radii_[query]));
  const Found found = kernels_.weightedSums(
      {last_, at, certain_, toFloat(queries_[query])}, limits, job_.weight, scale, t);
  std::size_t neighbours = found.certain;
  if (found.doubtful)
    for (const Index place : decide(query, at, limits)) {
      const Point offset(double{last_.x[place]} - double{at[0]},
                         double{last_.y[place]} - double{at[1]},
                         double{last_.z[place]} - double{at[2]});
      // A weight may end in a step on the ball: no other distance will do.
      const double distance = std::sqrt(squaredDistance(query, last_.id[place]));
      t.add(job_.settings.weighting(distance * (1 / radiusOf(query))), offset);
      ++neighbours;
    }
  found_[query] = static_cast<std::uint32_t>(neighbours);
  return precise(t, t.trace(), neighbours);
}

bool
BlockSweep::centredTensor(const Part& queries, std::size_t query, Moments& t)
{
  const Float3 at = local(query, queries.center);
  const Band limits = band(queries, query);
  dense_.reserve(last_.size);
  const Found found = kernels_.neighbours(last_, at, limits, dense_);
  if (found.doubtful) {
    for (const Index place : decide(query, at, limits)) {
      dense_.x[dense_.size] = last_.x[place] - at[0];
      dense_.y[dense_.size] = last_.y[place] - at[1];
      dense_.z[dense_.size] = last_.z[place] - at[2];
      ++dense_.size;
    }
    dense_.pad();
  }
  found_[query] = static_cast<std::uint32_t>(dense_.size);
  const auto scale = static_cast<float>(1 / (radii_[query] * radii_[query]));
  Moments reference;
  kernels_.momentsAround(dense_,
                         {0, 0, 0},
                         job_.settings.centroid == Centroid::WeightedMean
                             ? job_.settings.centroid_weighting
                             : Weighting(Kernel::Const),
                         scale,
                         reference);
  if (!(reference.count > 1e-3))
    return false;
  const Float3 center = toFloat(reference.first / reference.count);
  kernels_.momentsAround(dense_, center, job_.settings.weighting, scale, t);
  return precise(t, t.trace(), dense_.size);
}

double
BlockSweep::radiusOf(std::size_t query) const
{
  return job_.radii != nullptr ? (*job_.radii)[job_.queries.index(first_ + query)]
                               : job_.radius;
}

double
BlockSweep::squaredDistance(std::size_t query, std::uint32_t slot) const
{
  return (job_.surface.point(slot) - job_.queries.point(first_ + query)).squaredNorm();
}

bool
BlockSweep::isNeighbour(std::size_t query, std::uint32_t slot) const
{
  const double radius = radiusOf(query);
  return squaredDistance(query, slot) <= radius * radius;
}

const Indices&
BlockSweep::decide(std::size_t query, const Float3& at, Band band)
{
  doubtful_.clear();
  kernels_.inBand(last_, at, band, doubtful_);
  const auto out = [&](Index place) { return !isNeighbour(query, last_.id[place]); };
  doubtful_.erase(std::remove_if(doubtful_.begin(), doubtful_.end(), out),
                  doubtful_.end());
  return doubtful_;
}

Float3
BlockSweep::local(std::size_t query, const Point& center) const
{
  // The steps in which a point of the list came to its coordinates: a query that is a
  // point of the list is at distance 0 from itself.
  const Float3 q = toFloat(queries_[query]), c = toFloat(center);
  return {q[0] - c[0], q[1] - c[1], q[2] - c[2]};
}

Band
BlockSweep::band(const Part& queries, std::size_t query) const
{
  // Rounding of a coordinate of the list and of the query, and of their differences to
  // the center; each changes the distance, which is about the radius.
  const double radius = radii_[query];
  const double far = queries.longest + queries.size;
  const double coordinates = std::sqrt(3.0) * (2 * reach_ + far + queries.size);
  // Rounding of |p|^2 (three steps) and of the three steps to |p - q|^2 from it.
  const double steps = 3 * far * far + 3 * (far * far + 2 * far * queries.size);
  const double error = float_rounding * 1.25 * (2 * radius * coordinates + steps + 2);
  const double squared = radius * radius;
  return {static_cast<float>(squared - error), static_cast<float>(squared + error)};
}

bool
BlockSweep::precise(const Moments& t, double spread, std::size_t neighbours) const
{
  constexpr double wanted = 3e-5;
  const double trace = t.trace();
  // Errors of single weights are rounding, and add up as such.
  const double weights =
      4 * weight_error_.absolute * std::sqrt(static_cast<double>(neighbours)) +
      weight_error_.relative * spread;
  const double sums = 5e-7 * spread;
  const double coordinates =
      4 * float_rounding * (reach_ + 1) * std::sqrt(std::max(0.0, t.count * trace));
  return trace > 0 && t.count > 0 && weights + sums + coordinates <= wanted * trace;
}

} // namespace linelet::grid
