// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/curves/refined_settings.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief The evidence, a log-likelihood ratio, that a curve among \a points needs to
 * be accepted. */
double
evidenceNeeded(double points);

/** \brief Curves of a scene in which surfaces, crowns and clutter stand beside them.
 *
 * Points whose neighborhood is a surface at its own scale are not searched, but remain
 * part of the background. Where the others look linear at some scale, a curve is
 * followed both ways (\ref followCurve), stiff ones first; if it has more evidence
 * against the background around it than all starts together would give by chance, it is
 * refitted (\ref TrackFitter) and explains its points. All lengths follow from the
 * points around each curve.
 * \param[in] points finite points, no two in one place
 * \param[in] unit D
 * \return curves with the points explained by each edge, their noise and evidence
 * \throws Canceled */
ModelCurves
mixedCurves(const Points& points,
            double unit,
            const RefinedSettings& settings,
            ProgressMonitor* monitor);

} // namespace linelet
