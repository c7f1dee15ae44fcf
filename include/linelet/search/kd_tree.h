// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include <linelet/search/neighbor_search.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief A kd-tree in double, for neighborhoods of very different size such as the k
 * nearest points. UniformGrid is faster where all share one radius. */
class KdTree : public NeighborSearch {
public:
  /** \brief Builds the tree of \a points (copied) in O(n log n). */
  explicit KdTree(const Points& points);
  ~KdTree() override;
  KdTree(KdTree&&) noexcept;
  KdTree&
  operator=(KdTree&&) noexcept;

  void
  within(const Point& query, double radius, Indices& found) const override;

  double
  nearest(const Point& query, std::size_t count, Indices& found) const override;

  /** \brief Number of points that can be found (those with finite coordinates). */
  std::size_t
  size() const;

private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

} // namespace linelet
