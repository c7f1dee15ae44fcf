// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "mixture_state.h"
#include "node_system.h"

namespace linelet {

/** \brief Estimates the overall standard deviation of normal noise. */
void
measureNoise(MixtureState& mixture);

/** \brief Estimates how the noise varies along a curve, from the system of its nodes.
 */
void
measureWidths(MixtureState& mixture, MixtureCurve& state, NodeSystem& system);

} // namespace linelet
