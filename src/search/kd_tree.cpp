// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/search/kd_tree.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include <nanoflann.hpp>

#include <linelet/search/nearest_candidates.h>

#include "sort_indices.h"

namespace linelet {

namespace {

/** \brief nanoflann's interface to a set of points. */
struct PointSet {
  Points points;
  Indices indices; // input index of each point

  std::size_t
  kdtree_get_point_count() const
  {
    return points.size();
  }

  double
  kdtree_get_pt(std::size_t sorted_index, std::size_t axis) const
  {
    return points[sorted_index][static_cast<Eigen::Index>(axis)];
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

using Distance = nanoflann::L2_Simple_Adaptor<double, PointSet>;
using Sorted = nanoflann::KDTreeSingleIndexAdaptor<Distance, PointSet, 3, std::size_t>;
using Node = Sorted::Node;

// More points per leaf than nanoflann's 10: testing a point costs less than a node.
constexpr std::size_t leaf_size = 24;

/** \brief A result set for nanoflann that keeps the least distances in a heap. Its own
 * sorts by insertion, which takes minutes for thousands of neighbors. */
class LeastDistances {
public:
  /** \param[in,out] heap memory to use; afterwards a heap of the squared distances */
  LeastDistances(std::vector<double>& heap, std::size_t count)
      : heap_(heap), count_(count)
  {
    heap_.clear();
  }

  std::size_t
  size() const
  {
    return heap_.size();
  }

  bool
  full() const
  {
    return heap_.size() == count_;
  }

  bool
  addPoint(double squared, std::size_t /*sorted index*/)
  {
    if (full()) {
      // The bound may have shrunk since the leaf was entered.
      if (squared >= heap_.front())
        return true;
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.back() = squared;
    }
    else
      heap_.push_back(squared);
    std::push_heap(heap_.begin(), heap_.end());
    return true; // go on
  }

  double
  worstDist() const
  {
    return full() ? heap_.front() : std::numeric_limits<double>::infinity();
  }

private:
  std::vector<double>& heap_;
  std::size_t count_;
};

/** \brief Visits the leaves that a ball may reach. */
template <class Take>
class BallWalk {
public:
  /** \param[in] take called with the first sorted index of a leaf and the one after its
   * last */
  BallWalk(const Sorted& tree, const Point& center, double squared_radius, Take take)
      : center_(center),
        // Rounding: squares of boxes are summed in another order than those of points.
        reach_(squared_radius * (1 + 1e-12)),
        take_(std::move(take))
  {
    double squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = tree.root_bbox[axis].low;
      high_[axis] = tree.root_bbox[axis].high;
      squared += squaredGap(axis);
    }
    visit(*tree.root_node, squared);
  }

private:
  /** \brief An axis' part of the squared distance of the current box. */
  double
  squaredGap(std::size_t axis) const
  {
    const double at = center_[static_cast<Eigen::Index>(axis)];
    const double gap = std::max(std::max(low_[axis] - at, at - high_[axis]), 0.0);
    return gap * gap;
  }

  /** \param[in] squared distance of the node's box */
  void
  visit(const Node& node, double squared)
  {
    if (node.child1 == nullptr) {
      take_(node.node_type.lr.left, node.node_type.lr.right);
      return;
    }
    const auto& split = node.node_type.sub;
    const auto axis = static_cast<std::size_t>(split.divfeat);
    const double others = squared - squaredGap(axis);
    const double low = low_[axis], high = high_[axis];
    high_[axis] = split.divlow;
    visitIfNear(*node.child1, others + squaredGap(axis));
    high_[axis] = high;
    low_[axis] = split.divhigh;
    visitIfNear(*node.child2, others + squaredGap(axis));
    low_[axis] = low;
  }

  void
  visitIfNear(const Node& node, double squared)
  {
    if (squared <= reach_)
      visit(node, squared);
  }

  const Point center_;
  double reach_;
  Take take_;
  std::array<double, 3> low_{}, high_{};
};

} // namespace

struct KdTree::Tree {
  explicit Tree(const Points& points)
      : set(finitePoints(points)),
        sorted(3, set, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size))
  {
    // Store the points of a leaf contiguously.
    PointSet by_leaf;
    by_leaf.points.reserve(set.points.size());
    by_leaf.indices.reserve(set.points.size());
    for (std::size_t& sorted_index : sorted.vAcc) {
      by_leaf.points.push_back(set.points[sorted_index]);
      by_leaf.indices.push_back(set.indices[sorted_index]);
      sorted_index = by_leaf.points.size() - 1;
    }
    set = std::move(by_leaf);
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
  const PointSet& set = tree_->set;
  std::size_t count = 0;
  BallWalk(
      tree_->sorted, query, squared_radius, [&](std::size_t begin, std::size_t end) {
        // Write every index and advance only past neighbors: a branch here would be
        // mispredicted every other time.
        if (found.size() < count + (end - begin))
          found.resize(2 * (count + end - begin));
        for (std::size_t sorted_index = begin; sorted_index < end; ++sorted_index) {
          found[count] = set.indices[sorted_index];
          count += (set.points[sorted_index] - query).squaredNorm() <= squared_radius;
        }
      });
  found.resize(count);
  sortIndices(found);
}

double
KdTree::nearest(const Point& query, std::size_t count, Indices& found) const
{
  found.clear();
  count = std::min(count, size());
  if (count == 0 || !query.allFinite())
    return 0;
  thread_local std::vector<double> heap;
  LeastDistances least(heap, count);
  tree_->sorted.findNeighbors(least, query.data(), nanoflann::SearchParams());
  // Ties go to the lower index, and nanoflann's sums differ from ours in the last
  // digit.
  const double reach = heap.front() * (1 + 1e-12);
  const PointSet& set = tree_->set;
  thread_local std::vector<std::pair<double, Index>> candidates;
  candidates.clear();
  BallWalk(tree_->sorted, query, reach, [&](std::size_t begin, std::size_t end) {
    for (std::size_t sorted_index = begin; sorted_index < end; ++sorted_index) {
      const double distance = (set.points[sorted_index] - query).squaredNorm();
      if (distance <= reach)
        candidates.emplace_back(distance, set.indices[sorted_index]);
    }
  });
  return keepNearest(candidates, count, found);
}

} // namespace linelet
