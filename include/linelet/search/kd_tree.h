// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include <linelet/search/neighbor_search.h>

namespace linelet {

/** \brief A kd-tree in double: for neighborhoods of very different size, k nearest
 * points above all. Where all have one radius, UniformGrid is faster. */
class KdTree : public NeighborSearch {
public:
  /** \brief Sorts \a points (copied) in n log n time. */
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
