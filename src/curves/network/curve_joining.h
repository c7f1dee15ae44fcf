// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief Reverses \a curve. */
void
turnRound(ModelCurve& curve);

/** \brief Extends \a curve at its back by the nodes of \a bridge, which explains no
 * points. */
void
appendBridge(ModelCurve& curve, const Points& bridge);

/** \brief Extends \a first at its back by \a bridge and \a second. */
void
appendCurve(ModelCurve& first, const Points& bridge, const ModelCurve& second);

} // namespace linelet
