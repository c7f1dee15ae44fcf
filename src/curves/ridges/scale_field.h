// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include <linelet/search/kd_tree.h>
#include <linelet/support/points.h>

namespace linelet {

/** \brief Local spacing of points relative to the overall spacing.
 *
 * Where points lie twice as far apart, because of uneven sampling or noise that grows
 * along a curve, the field is about 2, and all lengths that a fit derives from the
 * scale unit are multiplied by it. Without points it is 1 everywhere. */
class ScaleField {
public:
  ScaleField() = default;

  /** \brief The distance of every point to its sixth neighbor, smoothed over its
   * neighborhood, relative to \a scale_unit; between 1/8 and 8.
   * \param[in] points finite points
   * \param[in] least_spread if the \ref spread is smaller, the field has no points and
   * is 1 everywhere
   * \param[in] search over \a points; null: a grid of its own */
  ScaleField(const Points& points,
             double scale_unit,
             double least_spread = 1,
             const NeighborSearch* search = nullptr);

  /** \brief This field for coordinates relative to \a origin; shares memory with it. */
  ScaleField
  from(const Point& origin) const
  {
    ScaleField field = *this;
    field.origin_ += origin;
    return field;
  }

  double
  at(const Point& x) const;

  /** \brief Upper bound of all values. */
  static constexpr double
  widest()
  {
    return 8;
  }

  /** \brief The scale unit of which this is a multiple. */
  double
  unit() const
  {
    return unit_;
  }

  /** \brief The ratio of wide to narrow spacings along curves: the ninth over the first
   * decile for points with a linear neighborhood; 1 if these are few. */
  double
  spread() const
  {
    return spread_;
  }

private:
  std::shared_ptr<const KdTree> tree_;
  std::shared_ptr<const std::vector<double>> values_;
  Point origin_ = Point::Zero();
  double unit_ = 0;
  double spread_ = 1;
};

} // namespace linelet
