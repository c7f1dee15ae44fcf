// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "track_state.h"

namespace linelet {

void
TrackState::advance(double h, double walk)
{
  at = ahead(h);
  direction = (direction + h * curvature).normalized();
  curvature -= direction.dot(curvature) * direction;
  Eigen::Matrix3d step;
  step << 1, h, 0.5 * h * h, 0, 1, h, 0, 0, 1;
  const double h2 = h * h, h3 = h2 * h;
  Eigen::Matrix3d noise; // of a curvature that walks at random
  noise << h3 * h2 / 20, h2 * h2 / 8, h3 / 6, h2 * h2 / 8, h3 / 3, h2 / 2, h3 / 6,
      h2 / 2, h;
  covariance = step * covariance * step.transpose() + walk * noise;
}

void
TrackState::observe(const Point& offset, double variance, double weight)
{
  const double innovation = covariance(0, 0) + variance;
  const Eigen::Vector3d gain = covariance.col(0) / innovation;
  const Point v = across(offset);
  at += weight * gain[0] * v;
  direction = (direction + weight * gain[1] * v).normalized();
  curvature += weight * gain[2] * v;
  curvature -= direction.dot(curvature) * direction;
  // Whether the point belongs to the curve is unknown, too (probabilistic data
  // association); v has two coordinates.
  covariance += gain * gain.transpose() *
                (weight * (1 - weight) * 0.5 * v.squaredNorm() - weight * innovation);
}

} // namespace linelet
