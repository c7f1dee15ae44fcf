// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <linelet/curves/curve_network.h>

#include "end_reach.h"

namespace linelet {

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
