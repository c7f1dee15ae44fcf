// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "mixture_state.h"

namespace linelet {

/** \brief Gives the curves of \a mixture nodes about \a spacing apart, times the local
 * scale if \a scales is not null. Curves that have lost their points or their length
 * are removed. */
void
resample(MixtureState& mixture, double spacing, const ScaleField* scales);

} // namespace linelet
