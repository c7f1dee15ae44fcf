// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/fragments/time_prediction.h>

#include <algorithm>
#include <set>

#include <Eigen/Dense>

namespace linelet::fragments {

void
TimePrediction::add(double points, double seconds)
{
  points_.push_back(points);
  seconds_.push_back(seconds);
  unit_ = std::max(1.0, *std::max_element(points_.begin(), points_.end()));
  const std::set<double> sizes(points_.begin(), points_.end());
  const auto rows = static_cast<Eigen::Index>(points_.size());
  std::fill(std::begin(coefficients_), std::end(coefficients_), 0.0);
  if (sizes.size() == 1) {
    const Eigen::Map<const Eigen::VectorXd> times(seconds_.data(), rows);
    // From a single size, only a rate can be estimated.
    if (points > 0)
      coefficients_[1] = times.mean() * unit_ / points;
    else
      coefficients_[0] = times.mean();
    return;
  }
  const auto terms = static_cast<Eigen::Index>(std::min<std::size_t>(3, sizes.size()));
  Eigen::MatrixXd powers(rows, terms);
  Eigen::VectorXd times(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double n = points_[static_cast<std::size_t>(i)] / unit_;
    times[i] = seconds_[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k < terms; ++k)
      powers(i, k) = k == 0 ? 1 : powers(i, k - 1) * n;
  }
  const Eigen::VectorXd fit = powers.colPivHouseholderQr().solve(times);
  for (Eigen::Index k = 0; k < terms; ++k)
    coefficients_[k] = fit[k];
}

double
TimePrediction::operator()(double points) const
{
  const double n = points / unit_;
  return std::max(0.0,
                  coefficients_[0] + n * (coefficients_[1] + n * coefficients_[2]));
}

} // namespace linelet::fragments
