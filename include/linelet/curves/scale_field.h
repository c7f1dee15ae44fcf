// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/search/uniform_grid.h>
#include <linelet/support/points.h>

namespace linelet {

/** \brief How widely points are spaced at a place, beside the spacing of all.
 *
 * Where points lie twice as far apart, as the sampling of a finely bent curve or a
 * noise that grows along it makes them, the field is about 2: all lengths that a fit
 * takes from the scale unit then grow by it. Without points it is 1 everywhere. */
class ScaleField {
public:
  ScaleField() : grid_({}, 1) {}

  /** \brief The distance of every point to its sixth neighbour, smoothed over its
   * neighbourhood, beside \a scale_unit; between 1/8 and 8.
   * \param[in] points finite points */
  ScaleField(const Points& points, double scale_unit);

  double
  at(const Point& x) const
  {
    const Index nearest = scales_.empty() ? UniformGrid::none : grid_.nearest(x);
    return nearest == UniformGrid::none ? 1 : scales_[nearest];
  }

  bool
  isUniform() const
  {
    return scales_.empty();
  }

  /** \brief The ratio of wide to narrow spacings along curves: that of the ninth to the
   * first decile of the points whose neighbourhood is linear; 1 where few are. */
  double
  spread() const
  {
    return spread_;
  }

private:
  UniformGrid grid_;
  std::vector<double> scales_;
  double spread_ = 1;
};

} // namespace linelet
