// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "component_model.h"

namespace linelet {

/** \name Model search
 * Each starts from the best fit of a component, tries other curves or another model of
 * the noise, and keeps what the criterion (\ref scoreOf) prefers. */
///@{

/** \brief Doubles curves that explain close parallel ones together: those of the best
 * fit, and those of other bandwidths if they are fewer.
 * \return the doubled best fit if the criterion has rejected it */
EmFit
doubleCurves(ComponentModel& component);

/** \brief Other ways to join the curves where they may be joined wrongly, at two
 * scales: at each such place by itself, unless there are many. */
void
rejoin(ComponentModel& component);

/** \brief Curves among the points that the fit leaves unexplained, such as a sparser
 * part of a curve.
 * \param[in] widest_unit points with a larger scale unit than this are left out */
void
traceTheRest(ComponentModel& component, double widest_unit);

/** \brief If the noise seems to vary along the curves, lets it vary and chooses among
 * the bandwidths again. */
void
followNoise(ComponentModel& component, const ScaleField* scales);

/** \brief Networks with fewer free ends or curves, if spacing or noise vary so that no
 * single bandwidth follows the curves throughout. */
void
simplify(ComponentModel& component);

/** \brief Fixed-radius noise, if the distances of the points allow it, for the best fit
 * and for \a other, which was rejected under normal noise. */
void
fitFixedRadius(ComponentModel& component, const EmFit& other);

/** \brief Curves assumed to bend evenly (\ref EmSettings::even_curvature), if their
 * shape takes more parameters than such curves need. */
void
evenCurvature(ComponentModel& component);

/** \brief Sharp corners where the curves bend strongly. */
void
sharpen(ComponentModel& component);

///@}

} // namespace linelet
