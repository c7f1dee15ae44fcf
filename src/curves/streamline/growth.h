// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/support/progress_monitor.h>

#include "direction_field.h"
#include "line_lets.h"

namespace linelet {

/** \brief When line-lets stop growing; lengths in the unit of the cloud. */
struct GrowthLimits {
  double step = 0;             ///< h
  double distance_cutoff = 0;  ///< to the nearest point
  double merge_distance = 0;   ///< to another line-let
  double branch_cosine = 0;    ///< of the sharpest turn that does not branch
  unsigned max_iterations = 0; ///< steps of one end
  std::size_t total_steps = 0; ///< of all ends together; counted down
  Point low = Point::Zero(), high = Point::Zero(); ///< bounds that may not be left
};

/** \brief Grows all ends of \a lets that are growing until none is left.
 *
 * Breadth first: in each round every end takes one step. The steps of a round are
 * computed from the state before it, then taken in the order of the line-lets, so that
 * the result does not depend on the number of \a threads. An end stops open if it is
 * farther than the cutoff from every point, leaves the bounds or has taken all its
 * steps; it stops closed if it meets a line-let (see \ref meet) or turns too sharply,
 * in which case a new line-let branches off.
 * \throws Canceled */
void
grow(LineLets& lets,
     const DirectionField& field,
     const CloudNeighbors& neighbors,
     GrowthLimits& limits,
     const StreamlineSettings& settings,
     ProgressMonitor* monitor = nullptr);

} // namespace linelet
