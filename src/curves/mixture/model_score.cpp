// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "model_score.h"

#include <cmath>

namespace linelet {

namespace {

constexpr double parameters_per_curve = 2;
constexpr double parameters_per_end = 1;   // where it lies along the curve
constexpr double parameters_per_hinge = 1; // besides its coordinates: its place
// A fit with at most this share of outliers counts as having none.
constexpr double no_outliers = 1.1e-3;

} // namespace

double
scoreOf(const EmFit& fit, std::size_t points)
{
  double parameters = fit.freedom + (fit.outlier_share > no_outliers ? 1 : 0);
  for (const ModelCurve& curve : fit.curves)
    parameters += parameters_per_curve + (curve.closed ? 0 : 2 * parameters_per_end) +
                  parameters_per_hinge * static_cast<double>(curve.hinges.size());
  return -2 * fit.log_likelihood + fit.width_cost +
         parameters * std::log(static_cast<double>(points));
}

double
scoreOfNothing(const CloudFrame& frame, std::size_t points)
{
  return 2 * static_cast<double>(points) * std::log(frame.volume);
}

} // namespace linelet
