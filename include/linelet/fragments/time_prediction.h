// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC fragments {

/** \brief Predicts the time of a fragment from its number of points n, learned from
 * finished ones: t = a + b n + c n^2 by least squares (Grasso et al. 2015, section 4).
 * While fewer than three different sizes are known, the highest terms are omitted.
 * Never negative. */
class TimePrediction {
public:
  /** \brief Adds a finished fragment that took \a seconds. */
  void
  add(double points, double seconds);

  /** \brief Whether any fragment is known. */
  bool
  known() const
  {
    return !points_.empty();
  }

  /** \brief Expected seconds of a fragment; 0 while none is known. */
  double
  operator()(double points) const;

private:
  std::vector<double> points_, seconds_;
  double unit_ = 1;             ///< largest number of points so far
  double coefficients_[3] = {}; ///< in multiples of unit_
};

} // namespace fragments
} // namespace linelet
