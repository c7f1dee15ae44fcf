// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "component_model.h"

namespace linelet {

/** \name Model search
 * Each function starts from the best fit of a component, tries other curves or another
 * noise model, and keeps what the criterion (\ref scoreOf) prefers. */
///@{

/** \brief Doubles curves that explain close parallel ones together: those of the best
 * fit, and those of other bandwidths if they are fewer.
 * \return the doubled best fit if the criterion has rejected it */
EmFit
doubleCurves(ComponentModel& component);

/** \brief Tries other ways to join the curves where they may be joined wrongly, at two
 * scales: one place at a time, unless there are many. */
void
rejoin(ComponentModel& component);

/** \brief Tries curves among the points that the fit leaves unexplained, such as a
 * sparser part of a curve.
 * \param[in] widest_unit points with a larger scale unit than this are left out */
void
traceTheRest(ComponentModel& component, double widest_unit);

/** \brief If the noise seems to vary along the curves, lets it vary and chooses the
 * bandwidth again. */
void
followNoise(ComponentModel& component, const ScaleField* scales);

/** \brief Tries networks with fewer free ends or curves, if spacing or noise vary so
 * much that no single bandwidth follows the curves throughout. */
void
simplify(ComponentModel& component);

/** \brief Tries fixed-radius noise, if the distances of the points allow it, for the
 * best fit and for \a other, which was rejected under normal noise. */
void
fitFixedRadius(ComponentModel& component, const EmFit& other);

/** \brief Tries curves assumed to bend evenly (\ref EmSettings::even_curvature), if
 * their shape takes more parameters than such curves need. */
void
evenCurvature(ComponentModel& component);

/** \brief Where there are several curves, tries straight segments (\ref
 * straightSegments), as they are and joined where their ends meet: ridges have no
 * direction where curves meet, cross, or pass each other closely.
 * \return whether they are better */
bool
trySegments(ComponentModel& component);

/** \brief Tries sharp corners where the curves bend strongly. */
void
sharpen(ComponentModel& component);

///@}

} // namespace linelet
