// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "ellipsoids.h"
#include "model/model.h"
#include "polylines.h"

namespace linelet::view {

/** \brief Curves, truth and wires of \a model; the selected one as \a chosen. */
void
showCurves(const Model& model, Polylines& lines, Polylines& chosen);

/** \brief The selected point as \a marks and its tensor, the preview box, and the line
 * that is being drawn. */
void
showSelection(const Model& model,
              const Points& drawn_line,
              Polylines& marks,
              Ellipsoids& own);

/** \brief The computed tensors of a few thousand points, or none. */
void
showTensors(const Model& model, bool everywhere, Ellipsoids& ellipsoids);

} // namespace linelet::view
