// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "edge_pairs.h"

namespace linelet {

/** \brief Grows and cuts back the free ends of curves. */
class FreeEnds {
public:
  /** \brief Cuts back ends and drops curves that the points do not need, by the
   * information criterion.
   * \return whether anything changed */
  bool
  prune(MixtureState& mixture, const EdgePairs& pairs);

  /** \brief Grows every free end by an edge of \a spacing, times the local scale if \a
   * scales is not null. */
  static void
  extend(MixtureState& mixture, double spacing, const ScaleField* scales);

private:
  std::size_t
  cheapestCut(const MixtureState& mixture,
              const EdgePairs& pairs,
              const MixtureCurve& state,
              int end,
              double penalty);

  std::vector<double> removed_; // per point, the share that a cut takes away
};

} // namespace linelet
