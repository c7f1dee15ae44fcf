// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/search/kd_tree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <nanoflann.hpp>

#include <linelet/search/nearest_candidates.h>

namespace linelet {

namespace {

/** \brief What nanoflann asks of a set of points. */
struct PointSet {
  Points points;
  Indices indices; // input index of each point

  std::size_t
  kdtree_get_point_count() const
  {
    return points.size();
  }

  double
  kdtree_get_pt(std::size_t slot, std::size_t axis) const
  {
    return points[slot][static_cast<Eigen::Index>(axis)];
  }

  template <class Box>
  bool
  kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

PointSet
finitePoints(const Points& points)
{
  PointSet set;
  set.points.reserve(points.size());
  set.indices.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite())
      continue;
    set.points.push_back(points[i]);
    set.indices.push_back(static_cast<Index>(i));
  }
  return set;
}

/** \brief Collects what may be near: the tree sums squares in another order than the
 * neighbour rule does, so the last digit decides there. */
struct Candidates {
  using DistanceType = double;

  double reach, beyond;
  std::vector<std::size_t>& slots;

  Candidates(double squared_radius, std::vector<std::size_t>& collected)
      : reach(squared_radius * (1 + 1e-12)),
        beyond(std::nextafter(reach, std::numeric_limits<double>::infinity())),
        slots(collected)
  {
  }

  std::size_t
  size() const
  {
    return slots.size();
  }

  bool
  full() const
  {
    return true;
  }

  bool
  addPoint(double squared, std::size_t slot)
  {
    if (squared <= reach)
      slots.push_back(slot);
    return true;
  }

  // The tree visits a box only if it is nearer than this, a point likewise.
  double
  worstDist() const
  {
    return beyond;
  }
};

} // namespace

struct KdTree::Tree {
  using Distance = nanoflann::L2_Simple_Adaptor<double, PointSet>;
  using Sorted =
      nanoflann::KDTreeSingleIndexAdaptor<Distance, PointSet, 3, std::size_t>;

  explicit Tree(const Points& points) : set(finitePoints(points)), sorted(3, set)
  {
    // What lies in one leaf shall lie side by side in memory, too.
    PointSet by_leaf;
    by_leaf.points.reserve(set.points.size());
    by_leaf.indices.reserve(set.points.size());
    for (std::size_t& slot : sorted.vAcc) {
      by_leaf.points.push_back(set.points[slot]);
      by_leaf.indices.push_back(set.indices[slot]);
      slot = by_leaf.points.size() - 1;
    }
    set = std::move(by_leaf);
  }

  /** \brief Slots of the points that may lie within a radius, and a few beyond. */
  const std::vector<std::size_t>&
  candidates(const Point& query, double squared_radius) const
  {
    thread_local std::vector<std::size_t> slots;
    slots.clear();
    Candidates result(squared_radius, slots);
    sorted.findNeighbors(result, query.data(), nanoflann::SearchParams());
    return slots;
  }

  PointSet set;
  Sorted sorted;
};

KdTree::KdTree(const Points& points) : tree_(std::make_unique<Tree>(points)) {}
KdTree::~KdTree() = default;
KdTree::KdTree(KdTree&&) noexcept = default;
KdTree&
KdTree::operator=(KdTree&&) noexcept = default;

std::size_t
KdTree::size() const
{
  return tree_->set.points.size();
}

void
KdTree::within(const Point& query, double radius, Indices& found) const
{
  found.clear();
  if (size() == 0 || !(radius >= 0) || !query.allFinite())
    return;
  const double squared_radius = radius * radius;
  for (const std::size_t slot : tree_->candidates(query, squared_radius))
    if ((tree_->set.points[slot] - query).squaredNorm() <= squared_radius)
      found.push_back(tree_->set.indices[slot]);
  std::sort(found.begin(), found.end());
}

double
KdTree::nearest(const Point& query, std::size_t count, Indices& found) const
{
  found.clear();
  count = std::min(count, size());
  if (count == 0 || !query.allFinite())
    return 0;
  thread_local std::vector<std::size_t> slots;
  thread_local std::vector<double> squared;
  slots.resize(count);
  squared.resize(count);
  tree_->sorted.knnSearch(query.data(), count, slots.data(), squared.data());
  // Which of several equally distant points come last is for the index to decide.
  thread_local std::vector<std::pair<double, Index>> candidates;
  candidates.clear();
  for (const std::size_t slot : tree_->candidates(query, squared[count - 1]))
    candidates.emplace_back((tree_->set.points[slot] - query).squaredNorm(),
                            tree_->set.indices[slot]);
  return keepNearest(candidates, count, found);
}

} // namespace linelet
