// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief Places where fitted \a curves may have been joined wrongly: where two
 * stretches pass each other within \a distance, where a curve ends at a junction, and
 * where it bends by more than 60 degrees within \a distance. */
Points
doubtfulPlaces(const ModelCurves& curves, double distance);

/** \brief \a curves with all that lies within \a radius of \a places removed; the new
 * ends are free. */
ModelCurves
cutAround(const ModelCurves& curves, const Points& places, double radius);

/** \brief How the arms of a cut are rejoined. */
enum class Rejoining {
  Paired, ///< with the straightest other arm of the same place
  Bridged ///< with whatever lies ahead
};

/** \brief \a curves joined in another way at \a places, where they may have been joined
 * wrongly (\ref doubtfulPlaces).
 *
 * They are cut there over \a size on either side, and the arms are rejoined.
 * \return nothing if there are no such places */
ModelCurves
rejoined(const ModelCurves& curves,
         const Points& places,
         double size,
         Rejoining rejoining);

} // namespace linelet
