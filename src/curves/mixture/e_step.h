// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "fixed_radius_noise.h"

namespace linelet {

/** \brief The E-step: the density of the mixture at every point, and the share of each
 * edge in it. */
class Expectation {
public:
  /** \brief Fills in the responsibilities of \a pairs, the counts of the edges, the
   * likelihood and the share of the outliers. */
  void
  operator()(MixtureState& mixture, EdgePairs& pairs, FixedRadiusNoise& fixed_radius);

  /** \brief Inverse of the density at each point, by sorted index. */
  const std::vector<double>&
  inverseDensities() const
  {
    return density_;
  }

private:
  std::vector<double> density_;
};

} // namespace linelet
