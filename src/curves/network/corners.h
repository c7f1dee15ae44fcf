// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief \a curves with a hinge in place of every bend by more than 40 degrees within
 * about \a size, where the lines along which the curve enters and leaves the bend meet.
 * Existing hinges are reconsidered.
 * \return nothing if no curve bends so sharply */
ModelCurves
sharpened(const ModelCurves& curves, double size);

} // namespace linelet
