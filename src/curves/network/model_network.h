// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/curves/curve_network.h>

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief The result of a reconstruction: \a curves with finer vertices, the number of
 * points that support each, and their ends joined where they meet (\ref connectEnds).
 */
CurveNetwork
networkOf(const ModelCurves& curves);

} // namespace linelet
