// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include <linelet/support/points.h>

namespace linelet {

/** \brief How long the steps of \ref AdaptiveDop853 are, in the unit of the points. */
struct StepControl {
  double tolerance = 0; ///< of the error of a step
  double first = 0;     ///< the first step to try
  double least = 0;     ///< taken whatever the error, where a field is rough
  double most = 0;
};

/** \brief The scheme of Dormand and Prince of order 8, its step controlled by the
 * embedded ones of order 5 and 3, with dense output of order 7 (Hairer, Norsett,
 * Wanner, Solving Ordinary Differential Equations I, 1993, section II.5 and II.6): a
 * streamline can be evaluated at any length, whatever the steps. */
class AdaptiveDop853 {
public:
  /** \brief The direction at a place; does not depend on time. */
  using Field = std::function<Point(const Point&)>;

  AdaptiveDop853(const Point& begin, const StepControl& control)
      : control_(control), next_(control.first), from_(begin), to_(begin)
  {
    dense_.fill(Point::Zero());
  }

  /** \brief Advances by \a length along \a field.
   * \return the place reached */
  Point
  advance(double length, const Field& field);

  /** \brief Number of evaluations of the field so far. */
  std::size_t
  evaluations() const
  {
    return evaluations_;
  }

private:
  void
  step(const Field& field);

  StepControl control_;
  double next_;       // step to be tried
  Point from_, to_;   // of the last step
  double length_ = 0; // of it
  double used_ = 0;   // how much of it has been used
  std::size_t evaluations_ = 0;
  std::array<Point, 7> dense_; // coefficients of the interpolation over it
};

} // namespace linelet
