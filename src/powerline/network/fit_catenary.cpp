// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/network/fit_catenary.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <ceres/ceres.h>

#include "powerline/line_priors.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr double degree = M_PI / 180;
constexpr std::size_t sample = 600;                // points that take part
constexpr double swing_spread = 0.3;               // radian
constexpr double flattest = 1e-5, tightest = 0.05; // 1 / a
constexpr double hold = 8; // weight of an attachment point, in points

/** Parameters, all near 0 in the frame of the start model except the bend: offset to
 * the left, turn, height and slope (as asinh) at s = 0, bend 1 / a, swing. */
enum { left, turn, height, slope, bend, swing, parameters };

/** Deviation of one point, in the start model's frame (s, t, z). */
struct Deviation {
  double s, t, z, weight;

  template <class T>
  bool
  operator()(const T* p, T* residual) const
  {
    using std::cos;
    using std::cosh;
    using std::sin;
    using std::sinh;
    using std::sqrt;
    const T along = cos(p[turn]) * s + sin(p[turn]) * t;
    const T across = cos(p[turn]) * t - sin(p[turn]) * s;
    // (cosh(k s + b) - cosh(b)) / k without losing digits at small k.
    const T half = p[bend] * along / 2.0;
    const T rise = 2.0 * sinh(half) * sinh(half + p[slope]) / p[bend];
    const T steep = sinh(p[bend] * along + p[slope]);
    residual[0] = weight * (across - p[left] + sin(p[swing]) * rise);
    residual[1] =
        weight * (z - p[height] - cos(p[swing]) * rise) / sqrt(1.0 + steep * steep);
    return true;
  }
};

struct Prior {
  template <class T>
  bool
  operator()(const T* p, T* residual) const
  {
    residual[0] = priors.point_noise / swing_spread * p[swing];
    residual[1] = priors.point_noise / (2 * priors.bend_spread) *
                  (p[bend] - 2 * priors.usual_bend);
    return true;
  }
};

} // namespace

Catenary
fitCatenary(const SpanModel& start,
            const Points& points,
            const Indices& members,
            const Points& fixed,
            double cut)
{
  const SpanModel m = start.reframed();
  const Eigen::Vector2d across(-m.direction.y(), m.direction.x());
  const auto deviation = [&](const Point& p, double weight) {
    return new ceres::AutoDiffCostFunction<Deviation, 2, parameters>(
        new Deviation{m.along(p), across.dot(p.head<2>() - m.origin), p.z(), weight});
  };
  std::array<double, parameters> p = {};
  p[height] = m.z[0];
  p[slope] = std::asinh(m.z[1]);
  p[bend] = std::clamp(2 * m.z[2], 2 * flattest, tightest / 2);
  p[swing] = std::clamp(-m.t[2] / std::max(m.z[2], 1e-4), -0.5, 0.5);

  ceres::Problem::Options keep;
  ceres::TukeyLoss loss(cut);
  keep.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(keep);
  const std::size_t stride = members.size() / sample + 1;
  for (std::size_t i = 0; i < members.size(); i += stride)
    problem.AddResidualBlock(deviation(points[members[i]], 1), &loss, p.data());
  for (const Point& place : fixed)
    problem.AddResidualBlock(deviation(place, hold), nullptr, p.data());
  problem.AddResidualBlock(
      new ceres::AutoDiffCostFunction<Prior, 2, parameters>(new Prior),
      nullptr,
      p.data());
  problem.SetParameterLowerBound(p.data(), bend, flattest);
  problem.SetParameterUpperBound(p.data(), bend, tightest);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 30;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

  // From the slope at s = 0 to the lowest point, where it vanishes.
  Catenary c;
  c.a = 1 / p[bend];
  c.swing = p[swing] / degree;
  const Eigen::Vector2d d =
      std::cos(p[turn]) * m.direction + std::sin(p[turn]) * across;
  const Eigen::Vector2d n(-d.y(), d.x());
  const double vertex = -p[slope] * c.a;
  const double half = p[bend] * vertex / 2;
  const double rise = 2 * c.a * std::sinh(half) * std::sinh(half + p[slope]);
  c.lowest.head<2>() =
      m.origin + vertex * d + (p[left] - std::sin(p[swing]) * rise) * n;
  c.lowest.z() = p[height] + std::cos(p[swing]) * rise;
  c.azimuth = std::atan2(d.x(), d.y()) / degree;
  if (c.azimuth < 0)
    c.azimuth += 360;
  c.from = c.along(m.at(m.begin));
  c.to = c.along(m.at(m.end));
  return c;
}

} // namespace linelet::powerline
