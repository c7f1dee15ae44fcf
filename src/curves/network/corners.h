// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief \a curves with a hinge in the place of every bend by more than 40 degrees
 * within about \a size: there the lines meet on which the curve runs up to the bend and
 * on from it. Hinges that they had are looked at anew.
 * \return nothing where no curve bends so */
ModelCurves
sharpened(const ModelCurves& curves, double size);

} // namespace linelet
