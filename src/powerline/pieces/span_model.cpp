// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/span_model.h"

#include <vector>

#include <Eigen/Dense>

#include "powerline/line_priors.h"

namespace linelet::powerline {

namespace {

// Standard deviations that the priors allow, in 1/meters.
constexpr double blow_out = 3e-5;

double
median(std::vector<double>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace

SpanModel
SpanModel::reframed() const
{
  SpanModel m = *this;
  const double middle = (begin + end) / 2;
  const double turn = slope(t, middle);
  const double stretch = std::sqrt(1 + turn * turn);
  m.origin = at(middle).head<2>();
  m.direction =
      (direction + turn * Eigen::Vector2d(-direction.y(), direction.x())) / stretch;
  m.begin = (begin - middle) * stretch;
  m.end = (end - middle) * stretch;
  m.t = {0, 0, t[2] / (stretch * stretch * stretch)};
  const Eigen::Vector2d more = beyondParabola(z);
  const double bend = z[2] + middle * (3 * more[0] + 6 * middle * more[1]);
  m.z = {height(middle), rise(middle) / stretch, bend / (stretch * stretch)};
  return m;
}

bool
fit(SpanModel& model, const Points& points, const Indices& members, double cut)
{
  const std::size_t n = members.size();
  std::vector<double> s(n), left(n), distance(n);
  const Eigen::Vector2d across(-model.direction.y(), model.direction.x());
  for (std::size_t i = 0; i < n; ++i) {
    const Point& p = points[members[i]];
    s[i] = model.along(p);
    left[i] = across.dot(p.head<2>() - model.origin);
    distance[i] = model.residual(p, s[i]).norm();
  }
  for (int iteration = 0; iteration < 3; ++iteration) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right_t = Eigen::Vector3d::Zero(), right_z = right_t;
    std::size_t used = 0;
    const Eigen::Vector2d more = SpanModel::beyondParabola(model.z);
    for (std::size_t i = 0; i < n; ++i) {
      const double u = distance[i] / cut;
      if (u >= 1)
        continue;
      const double w = (1 - u * u) * (1 - u * u);
      const Eigen::Vector3d x(1, s[i], s[i] * s[i]);
      normal += w * x * x.transpose();
      right_t += w * left[i] * x;
      const double beyond = s[i] * s[i] * s[i] * (more[0] + s[i] * more[1]);
      right_z += w * (points[members[i]].z() - beyond) * x;
      ++used;
    }
    if (used < 3)
      return false;
    Eigen::Matrix3d normal_t = normal, normal_z = normal;
    normal_t(2, 2) += std::pow(priors.point_noise / blow_out, 2);
    normal_z(2, 2) += std::pow(priors.point_noise / priors.bend_spread, 2);
    right_z[2] +=
        std::pow(priors.point_noise / priors.bend_spread, 2) * priors.usual_bend;
    model.t = normal_t.ldlt().solve(right_t);
    const auto solver = normal_z.ldlt();
    model.z = solver.solve(right_z);
    if (iteration == 2)
      model.covariance = solver.solve(Eigen::Matrix3d::Identity());
    if (!model.t.allFinite() || !model.z.allFinite())
      return false;
    for (std::size_t i = 0; i < n; ++i)
      distance[i] = model.residual(points[members[i]], s[i]).norm();
  }
  std::vector<double> near;
  for (const double d : distance)
    if (d < cut)
      near.push_back(d);
  if (near.size() < 3)
    return false;
  // The median of a two-dimensional normal deviation is 1.18 sigma.
  model.sigma = std::max(0.02, median(near) / 1.18);
  model.tolerance = std::clamp(3 * model.sigma, 0.10, model.widest);
  return true;
}

double
rootMeanSquare(const SpanModel& model, const Points& points, const Indices& members)
{
  double squares = 0;
  for (const Index i : members)
    squares += std::pow(model.distance(points[i]), 2);
  return std::sqrt(squares /
                   static_cast<double>(std::max<std::size_t>(1, members.size())));
}

} // namespace linelet::powerline
