// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "em_model.h"
#include "fixed_radius_noise.h"
#include "node_system.h"

namespace linelet {

/** \brief The M-step: moves the nodes to where the points pull them, and estimates
 * bending, noise and weights.
 * \param[in] may_straighten whether curves may become straight now (\ref straighten) */
void
maximize(MixtureState& mixture,
         EdgePairs& pairs,
         const FixedRadiusNoise& fixed_radius,
         NodeSystem& system,
         const EmSettings& settings,
         bool may_straighten = false);

} // namespace linelet
