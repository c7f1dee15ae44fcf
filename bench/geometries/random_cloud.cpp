// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <bench/geometries/random_cloud.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <bench/geometries/network_arc.h>
#include <Eigen/Geometry>

namespace linelet::bench {

namespace {

constexpr const char* prefix = "random-";
// Stretches pass each other at this many times the jitter, and never more closely than
// that: closer ones would look like one curve.
constexpr double clear_jitters = 2.5, least_gap = 0.8;
constexpr int student_freedom = 3;
constexpr double least_width = 1.0 / 9; // of varying noise, relative to its widest
constexpr double ball = 0.6;            // radius of the outliers, in diagonals
constexpr double farthest = 1000, smallest = 0.01, largest = 100; // of the placing

/** \brief Of noise and outliers. */
int
dimensionsOf(const RandomCloudKind& kind)
{
  return kind.flat && kind.noise != NoiseKind::FixedRadius ? 2 : 3;
}

/** \brief Draws what displaces a sample. */
class Noise {
public:
  Noise(const RandomCloudKind& kind, double jitter, Random& random)
      : kind_(kind),
        jitter_(jitter),
        periods_(random.integer(1, 3)),
        phase_(random.uniform(0, 2 * pi)),
        random_(random)
  {
  }

  /** \brief Of a sample at \a t of [0, 1] along the curves. */
  Point
  at(double t)
  {
    const int dimensions = dimensionsOf(kind_);
    Point normal = Point::Zero();
    for (int axis = 0; axis < dimensions; ++axis)
      normal[axis] = random_.normal(1);
    const double deviation = jitter_ / std::sqrt(dimensions);
    switch (kind_.noise) {
    case NoiseKind::FixedRadius:
      return jitter_ * normal.stableNormalized();
    case NoiseKind::Normal:
      return deviation * normal;
    case NoiseKind::Student: {
      double squares = 0;
      for (int k = 0; k < student_freedom; ++k) {
        const double draw = random_.normal(1);
        squares += draw * draw;
      }
      // Its variance is freedom / (freedom - 2) of the normal one.
      return deviation * std::sqrt((student_freedom - 2) / squares) * normal;
    }
    case NoiseKind::Varying: {
      const double wave = 0.5 + 0.5 * std::cos(2 * pi * periods_ * t + phase_);
      return std::pow(least_width, wave) * deviation * normal;
    }
    }
    return Point::Zero();
  }

private:
  RandomCloudKind kind_;
  double jitter_;
  int periods_; // of noise that varies, over all curves
  double phase_;
  Random& random_;
};

Point
inBall(int dimensions, Random& random)
{
  while (true) {
    Point p = Point::Zero();
    for (int axis = 0; axis < dimensions; ++axis)
      p[axis] = random.uniform(-1, 1);
    if (p.norm() <= 1)
      return p;
  }
}

double
diagonalOf(const CurveNetwork& network)
{
  Eigen::AlignedBox3d box;
  for (const Curve& curve : network.curves)
    for (const Point& p : curve.points)
      box.extend(p);
  return box.diagonal().norm();
}

void
place(RandomCloud& cloud, Random& random)
{
  Eigen::Quaterniond turn;
  for (int k = 0; k < 4; ++k)
    turn.coeffs()[k] = random.normal(1);
  turn.normalize();
  cloud.unit = smallest * std::pow(largest / smallest, random.uniform(0, 1));
  Point shift;
  for (int axis = 0; axis < 3; ++axis)
    shift[axis] = cloud.unit * random.uniform(-farthest, farthest);
  const auto move = [&](Point& p) { p = cloud.unit * (turn * p) + shift; };
  for (Point& p : cloud.points)
    move(p);
  for (Curve& curve : cloud.truth.curves)
    for (Point& p : curve.points)
      move(p);
  for (Junction& junction : cloud.truth.junctions)
    move(junction.position);
}

} // namespace

std::string
kindName(const RandomCloudKind& kind)
{
  return prefix + std::string(nameOf(kind.family)) + (kind.flat ? "-2d-" : "-3d-") +
         std::string(nameOf(kind.noise));
}

std::optional<RandomCloudKind>
randomCloudKind(std::string_view name)
{
  for (const auto& family : Names<ShapeFamily>::table)
    for (const bool flat : {true, false})
      for (const auto& noise : Names<NoiseKind>::table) {
        const RandomCloudKind kind{family.first, flat, noise.first};
        if (kindName(kind) == name)
          return kind;
      }
  return std::nullopt;
}

RandomCloud
randomCloud(const RandomCloudKind& kind, const SamplingSettings& sampling)
{
  Random random(static_cast<std::uint32_t>(sampling.seed));
  const double gap = std::max(least_gap, clear_jitters * sampling.jitter);
  RandomCloud cloud;
  cloud.truth = randomShape(kind.family, kind.flat, gap, random);
  const NetworkArc arc(cloud.truth);
  std::vector<double> ordered(sampling.points);
  for (double& t : ordered)
    t = random.uniform(0, 1);
  std::sort(ordered.begin(), ordered.end());
  Noise noise(kind, sampling.jitter, random);
  for (std::size_t i = 0; i < sampling.points; ++i) {
    const double even = static_cast<double>(i) / static_cast<double>(sampling.points);
    const double t =
        (1 - sampling.distribution) * even + sampling.distribution * ordered[i];
    cloud.points.push_back(arc.at(t) + noise.at(t));
  }
  const double radius = ball * diagonalOf(cloud.truth);
  for (std::size_t i = 0; i < sampling.outliers; ++i)
    cloud.points.push_back(radius * inBall(dimensionsOf(kind), random));
  place(cloud, random);
  return cloud;
}

} // namespace linelet::bench
