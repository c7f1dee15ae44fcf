// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "component_model.h"

namespace linelet {

/** \name Model search
 * Each starts from the best fit of a component, tries other curves or another model of
 * the noise, and keeps what the criterion (\ref scoreOf) prefers. */
///@{

/** \brief Curves that explain close parallel ones together are doubled: those of the
 * best fit, and those of other bandwidths where they are fewer.
 * \return the best fit's doubled one where the criterion has rejected it */
EmFit
doubleCurves(ComponentModel& component);

/** \brief Other ways to join the curves where they may be joined wrongly, on two
 * scales: at each such place by itself, unless there are many. */
void
rejoin(ComponentModel& component);

/** \brief Curves among the points that the fit leaves unexplained, such as a sparser
 * part of a curve.
 * \param[in] widest_unit points of a greater scale unit than this are left alone */
void
traceTheRest(ComponentModel& component, double widest_unit);

/** \brief Where the noise seems to vary along the curves, lets it, and chooses among
 * the bandwidths once more. */
void
followNoise(ComponentModel& component, const ScaleField* scales);

/** \brief Networks with fewer free ends or curves, where spacing or noise vary, so
 * that no bandwidth follows the curves all along. */
void
simplify(ComponentModel& component);

/** \brief Fixed-radius noise where the distances of the points may be such, for the
 * best fit and for \a other, which normal noise has rejected. */
void
fitFixedRadius(ComponentModel& component, const EmFit& other);

/** \brief Curves thought to bend evenly (\ref EmSettings::even_curvature), where their
 * shape takes more parameters than such curves need. */
void
evenCurvature(ComponentModel& component);

/** \brief Sharp corners where the curves bend strongly. */
void
sharpen(ComponentModel& component);

///@}

} // namespace linelet
