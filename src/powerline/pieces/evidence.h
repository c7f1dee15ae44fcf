// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"

namespace linelet::powerline {

/** \brief Evidence that a piece is a wire. */
struct Evidence {
  int bins = 0;      ///< of 2 m, begin to end
  int occupied = 0;  ///< with points of the wire
  int clean = 0;     ///< occupied, and hardly anything right around the wire
  double sag = 0;    ///< of the model between its ends, meters; negative: bulges upward
  double slope = 0;  ///< at the ends, against the chord
  double chord = 0;  ///< slope from end to end
  double height = 0; ///< mean of the members above ground, meters
  double likelihood = 0; ///< log-likelihood ratio (natural) of a wire to the
                         ///< surroundings alone, for the points around it
  bool hangs = false;    ///< like a wire, regardless of its surroundings
  bool sound = false;    ///< a wire, but perhaps too sparsely covered with points
  bool even = false;     ///< sound, its points spread nearly as if at random
  bool accepted = false; ///< sound and densely enough covered
};

/** \brief Weighs \a piece. Roof edges, crane booms and branches have other points
 * beside them everywhere; a wire hangs alone, or at a distance from others. */
Evidence
weigh(const Growth& growth, const Piece& piece, const PowerLineSettings& settings);

} // namespace linelet::powerline
