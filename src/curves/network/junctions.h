// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <linelet/curves/curve_network.h>

namespace linelet {

/** \brief How far the open ends of a curve look for others to be joined to. */
struct EndReach {
  double distance = 0; ///< to another curve
  double loop = 0; ///< along its own curve: closer places are not a meeting with itself
};

/** \brief By curve: of its front and of its back end. */
using EndReaches = std::vector<std::array<EndReach, 2>>;

/** \brief Finds where ends of curves meet and adds these junctions to the network.
 *
 * An open end meets another end, or the inside of a curve, that lies within its
 * distance, unless both run side by side there (within 20 degrees). Ends that meet form
 * one junction; they are moved to its position, which becomes a vertex of the curves
 * that pass there; a curve whose own ends meet is closed. Curves that cross without an
 * end form no junction.
 * \param[in,out] network open curves of at least two vertices and closed ones; no
 * junctions */
void
connectEnds(CurveNetwork& network, const EndReaches& reaches);

} // namespace linelet
