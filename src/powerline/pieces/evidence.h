// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"

namespace linelet::powerline {

/** \brief What speaks for a piece being a wire. */
struct Evidence {
  int bins = 0;     ///< of 2 m, begin to end
  int occupied = 0; ///< with points of the wire
  int clean = 0;    ///< occupied, and next to nothing right around the wire
  double rms = 0;   ///< of the members, meters
  double sag = 0;   ///< of the model between its ends, meters; negative: bulges upwards
  double slope = 0; ///< at the ends, against the chord
  double chord = 0; ///< slope from end to end
  double height = 0;     ///< mean of the members above ground, meters
  double likelihood = 0; ///< natural logarithm of how much better a wire explains the
                         ///< points around it than what stands there anyway does
  bool hangs = false;    ///< as a wire does, whatever is around it
  bool sound = false;    ///< a wire, but perhaps too thinly covered with points
  bool accepted = false; ///< and not that
};

/** \brief Weighs \a piece. Roof edges, crane booms and branches have company all along
 * themselves; a wire hangs alone, or beside others at a distance. */
Evidence
weigh(const Growth& growth, const Piece& piece, const PowerLineSettings& settings);

} // namespace linelet::powerline
