// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Which part of each row of a grid may lie in a cylinder. */
struct RowsOfCylinder {
  /** \param[in] from, to centers of its flat ends
   * \param[in] margin by which the cylinder is enlarged on all sides */
  RowsOfCylinder(const Point& from, const Point& to, double radius, double margin);

  /** \brief The first and the last x that the cylinder may reach in the row of all
   * (x, y, z) with y in \a y and z in \a z; the first is larger than the last if there
   * is none. */
  std::array<double, 2>
  alongRow(const std::array<double, 2>& y, const std::array<double, 2>& z) const;

  Point low, high; ///< the box around the cylinder

private:
  Point middle_;
  Point axis_;        // half of it
  double half_ = 0;   // half of its squared length
  double radius_ = 0; // of the cylinder
  double squared_reach_ = 0;
};

} // namespace linelet
