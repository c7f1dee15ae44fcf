// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <linelet/support/points.h>

namespace linelet::powerline {

/** \brief The view straight up from below: the lowest point of every cell of a plan
 * raster. Under a wire that is the ground, under a roof nothing. */
class Underside {
public:
  explicit Underside(const Points& points);

  /** \brief Height of the lowest point in the cell at a place; NaN where there is none.
   */
  float
  lowestAt(double x, double y) const;

  /** \brief Whether no point at all lies within \a reach (in x and in y) of a place. */
  bool
  emptyAround(double x, double y, double reach) const;

private:
  double cell_ = 1;
  double x_ = 0, y_ = 0; // corner of the first cell
  std::ptrdiff_t columns_ = 0, rows_ = 0;
  std::vector<float> lowest_;
};

} // namespace linelet::powerline
