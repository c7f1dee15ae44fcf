// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include "powerline/pieces/bundles.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

/** \brief One end of a wire: where it is attached, and to what. */
struct End {
  Point place = Point::Zero(); ///< attachment point, or the last place with points
  int partner = -1;     ///< wire that continues it beyond the support, -1: none seen
  int partner_side = 0; ///< its end there: 0 begin, 1 end
  int support = -1;     ///< index in the list of supports, -1: none seen
  bool fixed = false;   ///< place is an attachment point
};

/** \brief A wire with its two ends (0 begin, 1 end of its model). */
struct WireWithEnds {
  Strand strand;
  std::array<End, 2> ends;
  std::array<bool, 2> leaves = {}; ///< another line at that end, as service drops do

  const SpanModel&
  model() const
  {
    return strand.piece.model;
  }

  double
  edge(int side) const
  {
    return side == 0 ? model().begin : model().end;
  }

  /** \brief Horizontal unit vector out of the wire at one end. */
  Eigen::Vector2d
  outward(int side) const
  {
    return side == 0 ? Eigen::Vector2d(-model().direction) : model().direction;
  }
};

/** \brief Makes the points of \a wire free. */
void
release(const WireWithEnds& wire, Growth& growth);

} // namespace linelet::powerline
