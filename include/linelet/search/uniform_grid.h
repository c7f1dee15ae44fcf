// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <linelet/search/rows_of_cylinder.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Neighbor search over a fixed set of points, sorted into rows of a grid.
 *
 * Space is cut into square columns along x (the rows). Points within a row are sorted
 * by x, so that the neighbors of a query in one row are contiguous in memory. A point
 * belongs to the neighborhood of radius r if its squared distance, computed in double,
 * is at most r^2, as in every engine of linelet. Points with non-finite coordinates are
 * left out. Queries are thread-safe. */
class UniformGrid {
public:
  /** \brief Returned if there is no such point. */
  static constexpr Index none = std::numeric_limits<Index>::max();

  /** \brief Sorts \a points (copied; at most 2^32 - 2).
   * \param[in] points any points, in any order
   * \param[in] row_size width of a row, best near the most frequent radius; widened if
   * the rows would far outnumber the points
   * \throws std::invalid_argument unless \a row_size is positive and finite */
  UniformGrid(const Points& points, double row_size);

  /** \brief Number of points that can be found (those with finite coordinates). */
  std::size_t
  size() const
  {
    return points_.size();
  }

  /** \brief Calls visit(index, squared distance) for every point within \a radius of
   * \a query (d <= radius), in an order that depends only on the points. */
  template <class Visit>
  void
  forEachWithin(const Point& query, double radius, Visit&& visit) const
  {
    forEachSorted(query, radius, [&](std::size_t sorted_index, double squared) {
      visit(indices_[sorted_index], squared);
    });
  }

  /** \brief Calls visit(offset from the query, squared distance) for every point within
   * \a radius of \a query, in the order of \ref forEachWithin. */
  template <class Visit>
  void
  forEachOffsetWithin(const Point& query, double radius, Visit&& visit) const
  {
    forEachSorted(query, radius, [&](std::size_t sorted_index, double squared) {
      visit(Point(points_[sorted_index] - query), squared);
    });
  }

  /** \brief The points that can be found, in grid order. A point's place in it is its
   * sorted index. */
  const Points&
  sortedPoints() const
  {
    return points_;
  }
  /** \brief Input index of each sorted index. */
  const Indices&
  inputIndices() const
  {
    return indices_;
  }

  /** \brief Calls visit(begin, end) for runs of sorted indices, ascending, that
   * together hold every point within \a radius of \a query, and some others. */
  template <class Visit>
  void
  forEachRun(const Point& query, double radius, Visit&& visit) const;

  /** \brief Calls visit(begin, end) for runs of sorted indices, ascending, that
   * together hold every point of a cylinder, and some others.
   * \param[in] from, to middles of its flat ends */
  template <class Visit>
  void
  forEachRunInCylinder(const Point& from,
                       const Point& to,
                       double radius,
                       Visit&& visit) const;

  /** \brief Indices of the points within \a radius of \a query, in grid order. */
  Indices
  within(const Point& query, double radius) const;

  /** \brief Number of points within \a radius of \a query. */
  std::size_t
  countWithin(const Point& query, double radius) const;

  /** \brief The point nearest to \a query within \a max_distance, or \ref none. Ties go
   * to the lowest index. */
  Index
  nearest(const Point& query,
          double max_distance = std::numeric_limits<double>::infinity()) const;

  /** \brief The \a count points nearest to \a query (all if there are fewer), near to
   * far, ties by index. */
  Indices
  nearestK(const Point& query, std::size_t count) const;

  /** \brief A point that was found: its squared distance and its index. */
  using Neighbor = std::pair<double, Index>;

  /** \brief As above.
   * \param[in] radius > 0 to try first, doubled until enough are found; best slightly
   * more than the distance of the last neighbor
   * \param[out] found near to far, ties by index */
  void
  nearestK(const Point& query,
           std::size_t count,
           double radius,
           std::vector<Neighbor>& found) const;

  /** \brief Width of a row. */
  double
  rowSize() const
  {
    return row_size_;
  }

private:
  /** \brief Calls visit(begin, end) for every row that \a radius around \a query
   * reaches: its sorted indices from the first that is not left of the ball, or a few
   * before. */
  template <class Visit>
  void
  forEachRow(const Point& query, double radius, Visit&& visit) const;

  template <class Visit>
  void
  forEachSorted(const Point& query, double radius, Visit&& visit) const;

  /** \brief Where the rows of number \a row on \a axis begin and end; those on the
   * outside have no end. */
  std::array<double, 2>
  rowBounds(std::size_t row, int axis) const;

  /** \brief The first sorted index from \a begin on, in one row, that is not left of
   * \a x, or one of the few before. */
  std::size_t
  aboutFirst(std::size_t begin, std::size_t end, double x) const
  {
    for (std::size_t count = end - begin; count > few;) {
      const std::size_t half = count / 2;
      if (points_[begin + half].x() < x) {
        begin += half + 1;
        count -= half + 1;
      }
      else
        count = half;
    }
    return begin;
  }

  /** \brief The end of the points of one row, from \a begin on, that are not right of
   * \a x, or one of the few behind. */
  std::size_t
  aboutEnd(std::size_t begin, std::size_t end, double x) const
  {
    // Most runs are short: look for their end in growing steps.
    for (std::size_t step = 2 * few; begin + step < end; step *= 2) {
      if (points_[begin + step].x() > x) {
        end = begin + step;
        break;
      }
      begin += step;
    }
    while (end - begin > 2 * few) {
      const std::size_t half = begin + (end - begin) / 2;
      if (points_[half].x() <= x)
        begin = half + 1;
      else
        end = half;
    }
    return end;
  }

  /** \brief The nearest point seen so far. */
  struct Nearest {
    double squared;
    Index index;
  };

  /** \brief Looks for nearer points in a row, to both sides of the query. */
  void
  nearestInRow(std::size_t row, const Point& query, Nearest& best) const;

  /** \brief Chooses position, width and number of the rows. */
  void
  layRows(const Points& points);

  /** \brief Sorts the indices by row, and along x in each. */
  void
  sortIntoRows(const Points& points);

  std::size_t
  row(double coordinate, int axis) const
  {
    const double last = static_cast<double>(rows_[axis - 1] - 1);
    const double place = (coordinate - row_low_[axis]) / row_size_;
    return static_cast<std::size_t>(std::clamp(place, 0.0, last));
  }

  /// Shorter runs are scanned rather than bisected.
  static constexpr std::size_t few = 4;

  Points points_;                      // sorted by row, then x
  Indices indices_;                    // input index of each sorted point
  std::vector<std::size_t> row_begin_; // rows_[0] * rows_[1] + 1 entries, y fastest
  double row_size_;
  Point row_low_ = Point::Zero(); // where the first row begins, in y and z
  Point min_ = Point::Zero();
  Point max_ = Point::Zero();
  std::size_t rows_[2] = {0, 0}; // along y and z
};

template <class Visit>
void
UniformGrid::forEachRow(const Point& query, double radius, Visit&& visit) const
{
  if (points_.empty() || !(radius >= 0) || !query.allFinite())
    return;
  const Point low = query.array() - radius, high = query.array() + radius;
  if ((high.array() < min_.array()).any() || (low.array() > max_.array()).any())
    return;
  const std::size_t y_begin = row(low.y(), 1), y_end = row(high.y(), 1);
  const std::size_t z_end = row(high.z(), 2);
  for (std::size_t z = row(low.z(), 2); z <= z_end; ++z) {
    for (std::size_t y = y_begin; y <= y_end; ++y) {
      const std::size_t begin = row_begin_[z * rows_[0] + y];
      const std::size_t end = row_begin_[z * rows_[0] + y + 1];
      if (begin != end && points_[end - 1].x() >= low.x())
        visit(aboutFirst(begin, end, low.x()), end);
    }
  }
}

template <class Visit>
void
UniformGrid::forEachSorted(const Point& query, double radius, Visit&& visit) const
{
  const double squared_radius = radius * radius, high = query.x() + radius;
  forEachRow(query, radius, [&](std::size_t sorted_index, std::size_t end) {
    for (; sorted_index < end && points_[sorted_index].x() <= high; ++sorted_index) {
      const double squared = (points_[sorted_index] - query).squaredNorm();
      if (squared <= squared_radius)
        visit(sorted_index, squared);
    }
  });
}

template <class Visit>
void
UniformGrid::forEachRun(const Point& query, double radius, Visit&& visit) const
{
  const double high = query.x() + radius;
  forEachRow(query, radius, [&](std::size_t begin, std::size_t end) {
    if (points_[begin].x() <= high)
      visit(begin, aboutEnd(begin, end, high));
  });
}

template <class Visit>
void
UniformGrid::forEachRunInCylinder(const Point& from,
                                  const Point& to,
                                  double radius,
                                  Visit&& visit) const
{
  if (points_.empty() || !(radius >= 0) || !from.allFinite() || !to.allFinite())
    return;
  const double margin = 1e-3 * row_size_; // rounding errors are far smaller
  const RowsOfCylinder cylinder(from, to, radius, margin);
  const Point &low = cylinder.low, &high = cylinder.high;
  if ((high.array() < min_.array()).any() || (low.array() > max_.array()).any())
    return;
  const std::size_t y_begin = row(low.y(), 1), y_end = row(high.y(), 1);
  const std::size_t z_end = row(high.z(), 2);
  for (std::size_t z = row(low.z(), 2); z <= z_end; ++z) {
    const std::array<double, 2> z_bounds = rowBounds(z, 2);
    for (std::size_t y = y_begin; y <= y_end; ++y) {
      const auto [first, last] = cylinder.alongRow(rowBounds(y, 1), z_bounds);
      if (!(first <= last))
        continue;
      const std::size_t end = row_begin_[z * rows_[0] + y + 1];
      const std::size_t begin = aboutFirst(row_begin_[z * rows_[0] + y], end, first);
      if (begin != end && points_[begin].x() <= last)
        visit(begin, aboutEnd(begin, end, last));
    }
  }
}

} // namespace linelet
