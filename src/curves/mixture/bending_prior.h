// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "mixture_state.h"
#include "node_system.h"

namespace linelet {

/** \brief Measures the mean bend around each bend of a curve (\ref
 * EmSettings::even_curvature). */
void
measureEvenCurvature(const MixtureState& mixture, MixtureCurve& state, double spacing);

/** \brief Adds the prior on the bends of a curve to \a system. */
void
stiffen(const MixtureState& mixture,
        MixtureCurve& state,
        double spacing,
        NodeSystem& system);

/** \brief Estimates how strongly a curve bends from its solved bends. */
void
measureBending(const MixtureState& mixture,
               MixtureCurve& state,
               double spacing,
               const NodeSystem& system);

} // namespace linelet
