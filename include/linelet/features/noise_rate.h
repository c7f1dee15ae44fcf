// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/features/multi_scale_types.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Noise rate of a cloud of curves, n_R = 3.15 mean_i min_k CS_i(k) (Ritter,
 * Schiffner, Harders 2021, eq. 11).
 *
 * Without unit, 0 for clean curves, about 0 to 1: how far the neighborhoods of the
 * points are from flat at best. Grows with jitter, hardly moves with density, uneven
 * sampling and holes, little with outliers. Two properties to know: curves in a plane
 * get far smaller rates than curves in space of the same jitter, as their largest
 * neighborhoods are flat, and a clean crossing in space gets a rate above 0. \ref
 * noiseWidth has neither. The rates of curves in a plane that the paper prints come
 * with a largest radius of 5 D.
 *
 * \param[in] shapes made with Centroid::QueryPoint, for which the measure is defined;
 * points without a smallest sphericity are left out
 * \return NaN if there are no others */
double
noiseRate(const std::vector<MultiScaleShape>& shapes);

/** \brief How far the points of a cloud of curves are displaced from their curves, in
 * the unit of the cloud: 0.36 median_i(r_i sqrt(CS_i)) with the optimal radius r_i and
 * the sphericity CS_i there.
 *
 * At its optimal scale a neighborhood of a curve is about as long as r and as wide as
 * the noise, so that sqrt(l1) ~ r sqrt(CS). The factor is that of the ten test
 * geometries of the benchmark: samples displaced by S_J in random directions have a
 * width of S_J within a sixth up to S_J = 0.3 (the extent of the geometries is 10) on
 * all of them, within a fifth up to 0.6 on those whose parts are farther apart than the
 * noise reaches (not wave and mikado). The median takes no notice of the few points at
 * crossings. Blind for noise that stays in a plane or on a line.
 *
 * \param[in] shapes made with Centroid::QueryPoint; points without optimal scale are
 * left out
 * \return NaN if there are no others */
double
noiseWidth(const std::vector<MultiScaleShape>& shapes);

} // namespace linelet
