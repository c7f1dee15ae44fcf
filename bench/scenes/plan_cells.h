// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <linelet/support/points.h>

namespace linelet::bench {

/** \brief Which objects of a scene a ray may hit: their numbers in square cells of the
 * plan. */
class PlanCells {
public:
  PlanCells() = default;

  /** \param[in] low, high bounds of what is inserted
   * \param[in] cell width of a cell, meters */
  PlanCells(const Point& low, const Point& high, double cell);

  /** \brief Adds \a id to every cell that a box touches. */
  void
  insert(std::uint32_t id, const Point& low, const Point& high);

  /** \brief The objects in the cell at a place; outside the bounds, in the nearest
   * one. */
  const std::vector<std::uint32_t>&
  at(double x, double y) const
  {
    return cells_[cellOf(x, y)];
  }

private:
  std::size_t
  cellOf(double x, double y) const;

  Point low_ = Point::Zero();
  double cell_ = 1;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;
};

/** \brief Where a ray along a unit \a direction hits the triangle a b c: distance in
 * meters (Moeller and Trumbore 1997, without culling). */
std::optional<double>
meetTriangle(const Point& origin,
             const Point& direction,
             const Point& a,
             const Point& b,
             const Point& c);

} // namespace linelet::bench
