// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "powerline/line_priors.h"
#include "powerline/pieces/growth.h"

namespace linelet::powerline {

constexpr double flattest = 1 / (2 * priors.tautest); ///< z2 of a wire, 1/meters

constexpr double straight_length = 30; ///< meters from which sag can be measured

/** \brief z2 of a wire from its points alone, without the prior of the fit. */
struct Bend {
  double value = 0;
  double spread = 1; ///< standard deviation

  /** \brief Whether the points rule out a bend of \a least. */
  bool
  rulesOut(double least) const
  {
    return value + 2.5 * spread < least;
  }

  bool
  isAbove(double least) const
  {
    return value - 2.5 * spread > least;
  }
};

Bend
bendOf(const Piece& piece, const Points& points);

} // namespace linelet::powerline
