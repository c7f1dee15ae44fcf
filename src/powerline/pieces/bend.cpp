// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/bend.h"

#include <cmath>
#include <Eigen/Dense>

#include "powerline/pieces/growth.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr double robust_cut = 0.3;    // meters, Tukey's biweight
constexpr double least_noise = 0.015; // meters

} // namespace

Bend
bendOf(const Piece& piece, const Points& points)
{
  const SpanModel& m = piece.model;
  const double middle = (m.begin + m.end) / 2, half = m.length() / 2;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double squares = 0, count = 0;
  for (const Index i : piece.members) {
    const double s = m.along(points[i]);
    const Eigen::Vector2d r = m.residual(points[i], s);
    const double u = r.norm() / robust_cut;
    if (u >= 1)
      continue;
    const double w = (1 - u * u) * (1 - u * u);
    const Eigen::Vector3d x(1, (s - middle) / half, std::pow((s - middle) / half, 2));
    normal += w * x * x.transpose();
    right += w * points[i].z() * x;
    squares += w * r[1] * r[1];
    count += w;
  }
  Bend bend;
  if (count < 6)
    return bend;
  const auto solver = normal.ldlt();
  const double noise = std::max(least_noise, std::sqrt(squares / (count - 3)));
  bend.value = solver.solve(right)[2] / (half * half);
  bend.spread =
      noise * std::sqrt(solver.solve(Eigen::Vector3d::UnitZ())[2]) / (half * half);
  return bend;
}

} // namespace linelet::powerline
