// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "edge_pairs.h"

namespace linelet {

/** \brief Noise that puts points at about one distance from the curves: its part of the
 * E-step and of the M-step. */
class FixedRadiusNoise {
public:
  /** \brief The densities of \a edge at its points, into \a pairs. */
  static void
  densities(const MixtureState& mixture, const MixtureEdge& edge, EdgePairs& pairs);

  /** \brief Per point, the information it gives about its distance, relative to a point
   * whose position on the curve is known. */
  void
  measureInformation(const MixtureState& mixture, const EdgePairs& pairs);

  /** \brief The sums of \a edge for its vertices; see FixedRadiusKernels. */
  EdgeSums
  sums(const MixtureState& mixture,
       const MixtureEdge& edge,
       EdgePairs& pairs,
       bool front,
       bool back) const;

  /** \brief Estimates radius and deviation of the noise. */
  void
  measure(MixtureState& mixture, const EdgePairs& pairs) const;

private:
  std::vector<double> inlier_, residual_, information_; // per sorted index
};

} // namespace linelet
