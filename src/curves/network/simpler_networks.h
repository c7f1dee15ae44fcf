// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "curves/ridges/model_curve.h"
#include "curves/ridges/scale_field.h"

namespace linelet {

/** \brief Networks that may explain the same points as \a curves with fewer free ends
 * or curves, for a fit to decide.
 *
 * Free ends near each other are joined across gaps of 1.5 units whatever their
 * directions, and of 3, 6 and 12 units if these agree; once with the ends as they are,
 * and once cut back by the width of the gap, in case stray points have led them astray.
 * Each short curve is also left out once. The unit is \a scale_unit times the largest
 * of the \a scales (may be null) at a free end: a ring is open where its points are
 * sparsest. */
std::vector<ModelCurves>
simplerNetworks(const ModelCurves& curves,
                double scale_unit,
                const ScaleField* scales = nullptr);

} // namespace linelet
