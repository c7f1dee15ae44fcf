// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ridge_field.h"

#include <algorithm>
#include <cmath>

#include <linelet/tensor/shape_factors.h>

#include "sorted_kernels.h"

namespace linelet {

namespace {

// Points are ignored if their support is less than this share of the median, or than
// that of this many coincident points.
constexpr double least_share = 0.3;
constexpr double least_support = 1.5;

} // namespace

RidgeField::RidgeField(const Points& points, double bandwidth, const ScaleField* scales)
    : bandwidth_(bandwidth), scales_(scales), grid_(points, 3 * bandwidth)
{
  supports_.assign(points.size(), 0);
  if (grid_.size() == 0)
    return;
  sorted_ = std::make_shared<SortedArrays>(grid_);
  std::vector<double> scores(points.size());
  for (std::size_t sorted_index = 0; sorted_index < grid_.size(); ++sorted_index) {
    const Sample here = sample(grid_.sortedPoints()[sorted_index]);
    const Index i = grid_.inputIndices()[sorted_index];
    supports_[i] = here.support;
    scores[i] = here.support * (0.2 + linearityOf(here.covariance));
  }
  std::vector<double> sorted = supports_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  median_support_ = *middle;

  const double least = std::max(least_share * median_support_, least_support);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (supports_[i] >= least) {
      kept_.push_back(points[i]);
      kept_indices_.push_back(static_cast<Index>(i));
    }
    else
      supports_[i] = 0;
  }
  if (kept_.size() < points.size()) {
    grid_ = UniformGrid(kept_, 3 * bandwidth);
    sorted_ = std::make_shared<SortedArrays>(grid_);
  }
  seeds_ = kept_indices_;
  std::sort(seeds_.begin(), seeds_.end(), [&](Index a, Index b) {
    return scores[a] != scores[b] ? scores[a] > scores[b] : a < b;
  });
}

RidgeField::Sample
RidgeField::sample(const Point& x) const
{
  static thread_local std::vector<SortedRun> runs;
  runs.clear();
  const double radius = 3 * bandwidthAt(x);
  grid_.forEachRun(x, radius, [&](std::size_t begin, std::size_t end) {
    runs.push_back({begin, end});
  });
  Sample result;
  if (runs.empty())
    return result;
  FieldSums sums;
  sortedKernels().fieldSums(*sorted_, runs, x.data(), radius, sums);
  result.support = sums.weight;
  if (!(result.support > 0))
    return result;
  // Weighted by the smoothing kernel; the vectorized kernels have computed the sums.
  const Point first = Point(sums.first) / sums.weight;
  const auto& s = sums.second;
  result.covariance << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
  result.covariance /= sums.weight;
  result.covariance -= first * first.transpose();
  result.mean = x + first;
  return result;
}

} // namespace linelet
