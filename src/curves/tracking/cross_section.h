// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <Eigen/Core>

#include <linelet/search/uniform_grid.h>

#include "curves/mixture/em_model.h"

namespace linelet {

/** \brief Log-likelihood that the points of \a fit gain, at most, where they may
 * scatter about each of its curves more in one direction across than in the other, less
 * what the parameters of that cost by the Bayesian information criterion.
 *
 * The points of a thin wire scatter by the footprint of the beam across the scan, and
 * evenly over it, but only by the noise of the range along the beam. Under noise that
 * is the same in all directions, such a ribbon looks like several lines side by side.
 * Lines are told from it by comparing both with this gain.
 * \param[in] points that were fitted, with \a grid of them
 * \param[in] least_noise standard deviation below which no scatter is thought */
double
unevenScatterGain(const EmFit& fit,
                  const Points& points,
                  const UniformGrid& grid,
                  double least_noise);

/** \brief Log-likelihood that the points of \a one, which is one curve, gain as lines
 * side by side at \a offsets from it rather than as one ribbon, less what the
 * parameters of the lines cost by the Bayesian information criterion. The lines share
 * their scatter and the course of the curve. */
double
modesGain(const EmFit& one,
          const std::vector<Eigen::Vector2d>& offsets,
          const Points& points,
          const UniformGrid& grid,
          double least_noise);

} // namespace linelet
