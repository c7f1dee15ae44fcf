// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>

#include <linelet/tensor/weighting.h>

namespace linelet::grid {

/** \brief A weighting as polynomials of u = x^2, one for each of equal intervals of
 * [0, 1]: cheaper than roots and exponentials where lanes can look up coefficients.
 *
 * The polynomials are in u less the middle of the interval. */
struct WeightTable {
  static constexpr std::size_t intervals = 32;
  static constexpr int least_degree = 3, most_degree = 5;

  /** \brief Finds the lowest degree whose error is at most half of \ref weightError. */
  explicit WeightTable(const Weighting& weighting);

  int degree = 0; ///< 0: none is good enough
  /// U below which they must not be used: near 0 no polynomial follows a root
  float from = 0;
  std::array<std::array<float, intervals>, most_degree + 1> coefficients{};

private:
  bool
  fit(const Weighting& weighting, int with_degree);
};

/** \brief A weighting in the two forms in which the inner loops take it. */
struct SweepWeight {
  explicit SweepWeight(const Weighting& w) : weighting(w), table(w) {}

  Weighting weighting;
  WeightTable table;
};

} // namespace linelet::grid
