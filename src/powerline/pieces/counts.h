// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace linelet::powerline {

/** \brief Points in a stretch of the tube along a wire, and in its surroundings. */
struct Counts {
  double tube = 0;   ///< points
  double around = 0; ///< points around it
  double larger = 1; ///< volume of the surroundings, in volumes of the tube
};

/** \brief Log-likelihood ratio of a wire with \a density points per visible stretch in
 * addition to the surroundings, to the surroundings alone.
 *
 * The rate of the surroundings is known only from their count: both are negative
 * binomial (Poisson, with Jeffreys' prior of the rate). */
double
logWire(const Counts& counts, double density);

/** \brief The same for a wire that is hidden with probability \a hidden. */
double
logWire(const Counts& counts, double density, double hidden);

} // namespace linelet::powerline
