// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <vector>

#include <nanoflann.hpp>

#include "rivals.h"
#include "scenes.h"

namespace linelet::benchmarking {

namespace {

struct Adaptor {
  const Points& points;

  std::size_t
  kdtree_get_point_count() const
  {
    return points.size();
  }
  double
  kdtree_get_pt(std::size_t i, std::size_t axis) const
  {
    return points[i][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool
  kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

using Tree = nanoflann::
    KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adaptor>, Adaptor, 3>;

template <class Query>
RivalTime
measure(const Points& points, std::size_t sample, const Query& query)
{
  const Adaptor adaptor{points};
  RivalTime time{};
  double start = cpuSeconds();
  Tree tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  time.build = cpuSeconds() - start;
  start = cpuSeconds();
  const std::size_t step = points.size() / sample;
  for (std::size_t i = 0; i < sample; ++i)
    query(tree, points[i * step]);
  time.query = (cpuSeconds() - start) / static_cast<double>(sample);
  return time;
}

} // namespace

RivalTime
nanoflannSearch(const Points& points, double radius, std::size_t sample)
{
  std::vector<std::pair<std::uint32_t, double>> found;
  nanoflann::SearchParams unsorted;
  unsorted.sorted = false;
  return measure(points, sample, [&](const Tree& tree, const Point& query) {
    tree.radiusSearch(query.data(), radius * radius, found, unsorted);
  });
}

RivalTime
nanoflannNearest(const Points& points, std::size_t count, std::size_t sample)
{
  std::vector<std::uint32_t> found(count);
  std::vector<double> squared(count);
  return measure(points, sample, [&](const Tree& tree, const Point& query) {
    tree.knnSearch(query.data(), count, found.data(), squared.data());
  });
}

} // namespace linelet::benchmarking
