// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <bench/geometries/test_cloud.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <bench/geometries/network_arc.h>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

namespace linelet::bench {

namespace {

/** \brief Maps even positions in [0, 1] to positions that follow a density. */
class DensityWarp {
public:
  template <class Density>
  explicit DensityWarp(const Density& density) : sum_(steps + 1, 0.0)
  {
    for (std::size_t i = 0; i < steps; ++i)
      sum_[i + 1] = sum_[i] + density((static_cast<double>(i) + 0.5) / steps);
    for (double& value : sum_)
      value /= sum_.back();
  }

  double
  operator()(double t) const
  {
    const auto found = std::upper_bound(sum_.begin() + 1, sum_.end() - 1, t);
    const auto i = static_cast<std::size_t>(found - sum_.begin());
    const double inner = (t - sum_[i - 1]) / (sum_[i] - sum_[i - 1]);
    return (static_cast<double>(i - 1) + inner) / steps;
  }

private:
  static constexpr std::size_t steps = 1024;
  std::vector<double> sum_;
};

void
check(const SamplingSettings& s)
{
  const auto require = [](bool holds, const char* what) {
    if (!holds)
      throw std::invalid_argument(what);
  };
  require(s.distribution >= 0 && s.distribution <= 1,
          "distribution must lie in [0, 1]");
  require(s.jitter >= 0 && std::isfinite(s.jitter), "jitter must not be negative");
  require(std::isfinite(s.out_of_plane), "out-of-plane must be finite");
  require(s.hole[0] >= 0 && s.hole[0] <= s.hole[1] && s.hole[1] <= 1,
          "hole A,B must satisfy 0 <= A <= B <= 1");
}

template <class Density>
Points
sampleAlong(const CurveNetwork& network,
            const Density& density,
            const SamplingSettings& settings,
            const ProgressMonitor* monitor)
{
  check(settings);
  boost::random::mt19937_64 random(settings.seed);
  boost::random::uniform_01<double> uniform;
  const NetworkArc arc(network);
  const DensityWarp warp(density);

  std::vector<double> r(settings.points);
  for (double& value : r)
    value = uniform(random);
  std::sort(r.begin(), r.end());

  const bool hole = settings.hole[0] < settings.hole[1];
  const double n = static_cast<double>(settings.points);
  Points points;
  points.reserve(settings.points + settings.outliers);
  for (std::size_t i = 0; i < settings.points; ++i) {
    if (i % 8192 == 0)
      throwIfCanceled(monitor);
    const double t = static_cast<double>(i) / n;
    const double tau = (1 - settings.distribution) * t + settings.distribution * r[i];
    // One statement per draw: the order of evaluation is part of the result.
    const double x = 2 * uniform(random) - 1;
    const double y = 2 * uniform(random) - 1;
    const double z = 2 * uniform(random) - 1;
    const double position = warp(tau);
    if (hole && position >= settings.hole[0] && position <= settings.hole[1])
      continue;
    points.push_back(arc.at(position) +
                     settings.jitter * Point(x, y, z).stableNormalized());
  }
  if (settings.outliers == 0 || points.empty())
    return points;

  Point low = points.front(), high = low;
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double margin = 0.1 * (high - low).norm();
  for (int axis = 0; axis < 3; ++axis)
    if (high[axis] > low[axis] || settings.jitter > 0) {
      low[axis] -= margin;
      high[axis] += margin;
    }
  for (std::size_t i = 0; i < settings.outliers; ++i) {
    Point p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = low[axis] + uniform(random) * (high[axis] - low[axis]);
    points.push_back(p);
  }
  return points;
}

} // namespace

Points
sample(Geometry geometry,
       const SamplingSettings& settings,
       const ProgressMonitor* monitor)
{
  return sampleAlong(
      truthOf(geometry, settings.out_of_plane),
      [geometry](double t) { return densityOf(geometry, t); },
      settings,
      monitor);
}

Points
sample(const CurveNetwork& network,
       const SamplingSettings& settings,
       const ProgressMonitor* monitor)
{
  if (!(length(network) > 0))
    throw std::invalid_argument("the curves have no length to sample");
  return sampleAlong(
      network, [](double) { return 1.0; }, settings, monitor);
}

} // namespace linelet::bench
