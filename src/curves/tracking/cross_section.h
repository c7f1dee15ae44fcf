// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <Eigen/Core>

#include <linelet/search/uniform_grid.h>

#include "curves/mixture/em_model.h"

namespace linelet {

/** \brief Largest gain in log-likelihood for the points of \a fit if they may scatter
 * about each of its curves more in one direction across than in the other, less the
 * cost of the parameters by the Bayesian information criterion.
 *
 * The points of a thin wire scatter by the footprint of the beam across the scan, and
 * evenly over it, but only by the noise of the range along the beam. To isotropic
 * noise, such a ribbon looks like several lines side by side. Lines are distinguished
 * from it by comparing both with this gain.
 * \param[in] points that were fitted, with \a grid of them
 * \param[in] least_noise lower bound of the standard deviation */
double
unevenScatterGain(const EmFit& fit,
                  const Points& points,
                  const UniformGrid& grid,
                  double least_noise);

/** \brief Gain in log-likelihood for the points of \a one, a single curve, as lines
 * side by side at \a offsets from it rather than as one ribbon, less the cost of the
 * parameters of the lines by the Bayesian information criterion. The lines share their
 * scatter and the course of the curve. */
double
modesGain(const EmFit& one,
          const std::vector<Eigen::Vector2d>& offsets,
          const Points& points,
          const UniformGrid& grid,
          double least_noise);

} // namespace linelet
