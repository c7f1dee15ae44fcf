// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>

#include <linelet/support/points.h>

#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

/** \brief A wire under construction: a model and the candidates that it explains. */
struct Piece {
  SpanModel model;
  Indices members;      ///< candidates
  double thickness = 0; ///< radius of a bundle whose conductors cannot be resolved

  /** \brief Residual beyond which a point has no weight: a bundle must be fitted at its
   * center, not to whichever conductor is nearer. */
  double
  cut() const
  {
    return std::max({usual_cut, 2 * thickness, usual_cut / widest_wire * model.widest});
  }

  /** \brief Largest distance of a point that belongs to it. */
  double
  tolerance() const
  {
    return std::max(model.tolerance, thickness);
  }
};

/** \brief Makes the model of \a piece begin and end where its members do. */
void
updateExtent(Piece& piece, const Points& points);

} // namespace linelet::powerline
