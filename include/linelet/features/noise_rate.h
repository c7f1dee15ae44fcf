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
 * Dimensionless, 0 for clean curves, about 0 to 1: how far from flat the neighborhoods
 * of the points are at the scale where they are flattest. It grows with jitter, hardly
 * changes with density, uneven sampling and holes, and little with outliers. Two
 * caveats: curves in a plane get far smaller rates than curves in space with the same
 * jitter, as their largest neighborhoods are flat, and a clean crossing in space gets a
 * rate above 0. \ref noiseWidth has neither flaw. The rates that the paper prints for
 * curves in a plane are obtained with a largest radius of 5 D.
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
 * noise reaches (not wave and mikado). The median ignores the few points at crossings.
 * Noise within a plane or along a line is not seen.
 *
 * \param[in] shapes made with Centroid::QueryPoint; points without an optimal scale are
 * left out
 * \return NaN if there are no others */
double
noiseWidth(const std::vector<MultiScaleShape>& shapes);

} // namespace linelet
