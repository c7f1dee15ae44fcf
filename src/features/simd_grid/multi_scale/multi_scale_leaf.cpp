// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The records of a leaf, from its list of candidates.

#include <algorithm>
#include <cmath>
#include <limits>

#include "multi_scale_sweep.h"

namespace linelet::grid {

void
MultiScaleSweep::countHere(const Part& queries)
{
  // Places that may coincide are compared in double.
  const double near = 4 * float_rounding * queries.size + 1e-14;
  Lanes<float> counts;
  kernels_.coincident(core_, static_cast<float>(near * near), at_, counts);
  const bool own = &job_.queries == &job_.surface;
  const float expected = own ? 1 : 0;
  for (std::size_t lane = 0; lane < shapes_.count; ++lane) {
    shapes_.here[lane] = own ? 1 : 0;
    if (counts[lane] >= expected && counts[lane] <= expected)
      continue;
    const Point at = job_.queries.point(first_ + queries.begin + lane);
    std::uint32_t here = 0;
    for (std::size_t i = 0; i < core_.size; ++i)
      if ((job_.surface.point(core_.id[i]) - at).squaredNorm() <= 0)
        ++here;
    shapes_.here[lane] = here;
  }
}

void
MultiScaleSweep::sums(const Part& queries, const Level& level)
{
  const Reference reference =
      job_.settings.centroid == Centroid::Mean ? Reference::Mean : Reference::Query;
  for (std::size_t k = 0; k < radii_.size(); ++k) {
    Moments certain;
    open(queries, level.open[k + 1], scales_[k].near, scales_[k].far, leaf_, certain);
    kernels_.constPairs(
        leaf_, at_, scales_[k], static_cast<std::uint16_t>(k), sums_[k], doubts_);
    settle(queries, Kernel::Const, sums_);
    doubts_.clear();
    certain += level.inside[k + 1].relativeTo(queries.center);
    finish(queries, k, sums_[k], &certain, reference, scales_[k].relative);
  }
}

void
MultiScaleSweep::weights(const Part& queries)
{
  kernels_.weightedPairs(leaf_,
                         ends_.data(),
                         at_,
                         scales_.data(),
                         scales_.size(),
                         weight_,
                         false,
                         sums_.data(),
                         doubts_);
  settle(queries, job_.settings.weighting, sums_);
  for (std::size_t k = 0; k < radii_.size(); ++k)
    finish(queries, k, sums_[k], nullptr, Reference::Query, scales_[k].relative);
}

void
MultiScaleSweep::centered(const Part& queries)
{
  const Weighting& weighting = job_.settings.weighting;
  std::fill(center_sums_.begin(), center_sums_.end(), ScaleSums());
  kernels_.weightedPairs(leaf_,
                         ends_.data(),
                         at_,
                         scales_.data(),
                         scales_.size(),
                         center_weight_,
                         true,
                         center_sums_.data(),
                         doubts_);
  settle(queries, center_weight_.weighting, center_sums_);
  std::size_t next = 0; // doubts are sorted by scale
  for (std::size_t k = 0; k < radii_.size(); ++k) {
    ScaleSums& sums = sums_[k];
    const ScaleSums& center = center_sums_[k];
    LeafQueries centers;
    for (std::size_t lane = 0; lane < leaf_queries; ++lane) {
      const double total = center.sum[Total][lane];
      const auto place = [&](Moment m, const Lanes<float>& at) {
        const double from = scales_[k].relative ? static_cast<double>(at[lane]) : 0.0;
        return static_cast<float>(from + center.sum[m][lane] / total);
      };
      if (!(total > 1e-3))
        sums.sum[Total][lane] = -std::numeric_limits<double>::infinity(); // not good
      centers.x[lane] = place(X, at_.x);
      centers.y[lane] = place(Y, at_.y);
      centers.z[lane] = place(Z, at_.z);
    }
    kernels_.centeredPairs(leaf_, ends_[k], at_, scales_[k], centers, weight_, sums);
    for (; next < doubts_.size() && doubts_[next].scale == k; ++next)
      for (std::size_t lane = 0; lane < shapes_.count; ++lane)
        if ((doubts_[next].queries >> lane & 1) != 0) {
          const std::size_t place = doubts_[next].place;
          const auto offset = [](float a, float b) {
            return static_cast<double>(a) - static_cast<double>(b);
          };
          const Point v(offset(leaf_.x[place], centers.x[lane]),
                        offset(leaf_.y[place], centers.y[lane]),
                        offset(leaf_.z[place], centers.z[lane]));
          add(weighting(v.norm() / radii_[k]), v, lane, sums);
        }
    sums.found = center.found;
    finish(queries, k, sums, nullptr, Reference::Sums, true);
  }
}

void
MultiScaleSweep::add(double weight, const Point& v, std::size_t lane, ScaleSums& sums)
{
  const std::array<double, moments> terms = {1,
                                             v.x(),
                                             v.y(),
                                             v.z(),
                                             v.x() * v.x(),
                                             v.x() * v.y(),
                                             v.x() * v.z(),
                                             v.y() * v.y(),
                                             v.y() * v.z(),
                                             v.z() * v.z()};
  for (std::size_t m = 0; m < moments; ++m)
    sums.sum[m][lane] += weight * terms[m];
}

void
MultiScaleSweep::settle(const Part& queries,
                        const Weighting& weighting,
                        std::vector<ScaleSums>& sums)
{
  if (doubts_.empty())
    return;
  for (Doubt& doubt : doubts_) {
    const double radius = job_.radii[doubt.scale];
    const Point candidate = job_.surface.point(leaf_.id[doubt.place]);
    const Point about_center(
        leaf_.x[doubt.place], leaf_.y[doubt.place], leaf_.z[doubt.place]);
    for (std::size_t lane = 0; lane < leaf_queries; ++lane) {
      if ((doubt.queries >> lane & 1) == 0)
        continue;
      const Point query = job_.queries.point(first_ + queries.begin + lane);
      const double squared = (candidate - query).squaredNorm();
      if (lane >= shapes_.count || !(squared <= radius * radius)) {
        doubt.queries = static_cast<std::uint16_t>(doubt.queries & ~(1U << lane));
        continue;
      }
      const Point v = about_center -
                      Point(exact_at_[0][lane], exact_at_[1][lane], exact_at_[2][lane]);
      ScaleSums& sum = sums[doubt.scale];
      // A weight may end in a step on the ball: no other distance will do.
      add(weighting(std::sqrt(squared) * (1 / radius)),
          scales_[doubt.scale].relative ? v : about_center,
          lane,
          sum);
      sum.found[lane] += 1;
    }
  }
  std::stable_sort(doubts_.begin(), doubts_.end(), [](const Doubt& a, const Doubt& b) {
    return a.scale < b.scale;
  });
}

void
MultiScaleSweep::finish(const Part& queries,
                        std::size_t scale,
                        const ScaleSums& sums,
                        const Moments* inside,
                        Reference reference,
                        bool relative)
{
  Lanes<float> found;
  const double radius = searched_[scale];
  const std::uint32_t good = kernels_.finish({sums,
                                              inside,
                                              relative,
                                              reference,
                                              exact_at_,
                                              4 * coordinateError(scale, queries.size),
                                              weight_error_.absolute * radius * radius,
                                              weight_error_.relative},
                                             shapes_.tensors[scale],
                                             found);
  Lanes<float>& linearity = shapes_.linearity[scale];
  Lanes<float>& planarity = shapes_.planarity[scale];
  Lanes<float>& sphericity = shapes_.sphericity[scale];
  kernels_.factors(shapes_.tensors[scale], linearity, planarity, sphericity);
  for (std::size_t lane = 0; lane < shapes_.count; ++lane) {
    const auto neighbors = static_cast<std::uint32_t>(found[lane]);
    shapes_.neighbors[scale][lane] = neighbors;
    // One neighbor beside the point spans a line whatever the shape of the cloud.
    if (neighbors < shapes_.here[lane] + 2)
      linearity[lane] = planarity[lane] = sphericity[lane] =
          std::numeric_limits<float>::quiet_NaN();
    else if ((good >> lane & 1) == 0)
      redo_[lane] = scale + 1;
  }
}

void
MultiScaleSweep::inDouble(std::size_t begin, std::size_t lane, std::size_t scales)
{
  const Point query = job_.queries.point(first_ + begin + lane);
  const double radius = job_.radii[scales - 1];
  sweep_.clear();
  for (std::size_t g = 0; g < region_.size; ++g) {
    const Point center(region_.x[g], region_.y[g], region_.z[g]);
    if ((center - queries_[begin + lane]).norm() >
        radii_[scales - 1] + margin + double{region_.h[g]})
      continue;
    for (std::uint32_t i = 0; i < places_.size[g]; ++i) {
      const Point offset = job_.surface.point(places_.begin[g] + i) - query;
      const double squared = offset.squaredNorm();
      if (squared <= radius * radius)
        sweep_.add(offset, squared);
    }
  }
  sweep_.run(scales);
  shapes_.here[lane] = sweep_.neighbors().back() - sweep_.neighborsBeside().back();
  for (std::size_t k = 0; k < scales; ++k) {
    shapes_.neighbors[k][lane] = sweep_.neighbors()[k];
    const ShapeFactors& factors = sweep_.factors()[k];
    shapes_.linearity[k][lane] = static_cast<float>(factors.linearity);
    shapes_.planarity[k][lane] = static_cast<float>(factors.planarity);
    shapes_.sphericity[k][lane] = static_cast<float>(factors.sphericity);
    SymmetricTensor t = sweep_.tensors()[k];
    t *= 1 / (job_.unit * job_.unit);
    const std::array<double, 6> entries = {t.xx, t.xy, t.xz, t.yy, t.yz, t.zz};
    for (std::size_t entry = 0; entry < 6; ++entry)
      shapes_.tensors[k][entry][lane] = entries[entry];
  }
}

} // namespace linelet::grid
