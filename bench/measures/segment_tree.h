// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include <linelet/curves/curve_network.h>
#include <linelet/support/points.h>

namespace linelet::bench {

/** \brief Exact nearest segment of a curve network. A binary tree of bounding boxes
 * over the segments in their order along the curves: neighbors on a curve are neighbors
 * in space, so no sorting is needed. */
class SegmentTree {
public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  /** \brief An edge of a curve; for a curve of a single vertex, that vertex. */
  struct Segment {
    Point a, b;
    std::size_t curve = 0; ///< index in CurveNetwork::curves
    double arc = 0;        ///< arc length of the curve up to a
  };

  /** \brief The point of the network nearest to a query. */
  struct Nearest {
    std::size_t segment = none;
    double parameter = 0; ///< in [0, 1] from a to b
    double squared_distance = std::numeric_limits<double>::infinity();
  };

  explicit SegmentTree(const CurveNetwork& network);

  const std::vector<Segment>&
  segments() const
  {
    return segments_;
  }

  /** \brief The nearest point of the network (segment none if it has no vertex).
   * \param[in] hint a segment that is probably near, to save work, or none */
  Nearest
  nearest(const Point& query, std::size_t hint = none) const;

  /** \brief The nearest point of curve number \a curve of the network. */
  Nearest
  nearestOn(std::size_t curve, const Point& query) const;

private:
  struct Box {
    Point low = Point::Constant(std::numeric_limits<double>::infinity());
    Point high = Point::Constant(-std::numeric_limits<double>::infinity());
  };

  void
  test(const Point& query, std::size_t segment, Nearest& best) const;
  void
  descend(std::size_t node, const Point& query, Nearest& best) const;

  std::vector<Segment> segments_;
  std::vector<Box> boxes_; // heap order; the last `leaves_` are those of the segments
  std::size_t leaves_ = 0;
};

} // namespace linelet::bench
