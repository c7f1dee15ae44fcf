// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "mixture_state.h"
#include "node_system.h"

namespace linelet {

/** \brief Makes an open curve without hinges straight if the information criterion
 * prefers that: if the parameters that it saves cost more than the likelihood it loses.
 *
 * The scale of the bending prior is estimated from a few bends and never vanishes, so
 * that a straight curve would otherwise cost as many parameters as one that winds a
 * little.
 * \param[in] system what the points of the curve have added to it, and nothing else */
void
straighten(const MixtureState& mixture, MixtureCurve& state, const NodeSystem& system);

} // namespace linelet
