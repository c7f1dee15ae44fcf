// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Every direction mode against its definition, by brute force over all points.

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <linelet/features/multi_scale.h>

#include "curves/streamline/direction_field.h"
#include "random_seed.h"

using namespace linelet;

namespace {

Point
turned(const Point& direction, const Point& last)
{
  return direction.dot(last) < 0 ? Point(-direction) : direction;
}

/** A scattered arc whose features vary from point to point, so that a mode that uses
 * those of the wrong point fails. */
struct Arc {
  Points points;
  MultiScaleShapes shapes;
  StreamlineSettings settings;

  explicit Arc(unsigned seed)
  {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 0.1);
    std::uniform_real_distribution<double> radius(0.5, 1.5), blend(0.2, 0.8);
    for (int i = 0; i < 120; ++i) {
      const double a = 0.02 * i;
      points.emplace_back(4 * std::cos(a) + noise(random),
                          4 * std::sin(a) + noise(random),
                          0.1 * a + noise(random));
      const Point tangent(-std::sin(a), std::cos(a), 0);
      const Point major =
          (tangent + 3 * Point(noise(random), noise(random), noise(random)))
              .normalized();
      MultiScaleShape shape;
      shape.optimal_radius = static_cast<float>(radius(random));
      shape.blend = static_cast<float>(blend(random));
      shape.major_x = static_cast<float>(major.x());
      shape.major_y = static_cast<float>(major.y());
      shape.major_z = static_cast<float>(major.z());
      shapes.shapes.push_back(shape);
    }
    shapes.scale_unit = 0.25;
    shapes.radii = {0.3, 0.5, 0.8, 1.2, 1.8};
    settings.shape.centroid = Centroid::QueryPoint;
    settings.shape.radii = shapes.radii;
    settings.interpolation_radius = 0; // that of the nearest point
    settings.search_radius = 4;
  }
};

/** The directions at one place. */
class Definition {
public:
  Definition(const Arc& arc, const Point& at, const Point& last)
      : arc_(arc), at_(at), last_(last), nearest_(0)
  {
    for (std::size_t i = 1; i < arc.points.size(); ++i)
      if ((arc.points[i] - at).norm() < (arc.points[nearest_] - at).norm())
        nearest_ = i;
    radius_ = optimalRadius(nearest_);
  }

  Point
  of(DirectionMode mode) const
  {
    const auto blended = [&](double mu, const Point& e, const Point& a) {
      return Point((mu * e + (1 - mu) * a).normalized());
    };
    const double mu = static_cast<double>(arc_.shapes.shapes[nearest_].blend);
    switch (mode) {
    case DirectionMode::Eigenvector:
      return interpolated().normalized();
    case DirectionMode::Tensor:
      return turned(major(interpolatedTensor()), last_);
    case DirectionMode::Angular:
      return ahead(false);
    case DirectionMode::EigenvectorAngular:
      return blended(mu, interpolated(), ahead(false));
    case DirectionMode::EigenvectorAngularDistance:
      return blended(mu, interpolated(), ahead(true));
    case DirectionMode::TensorDeflection:
      return (interpolatedTensor() * last_).normalized();
    case DirectionMode::ClosestAngular:
      return blended(mu, turned(eigenvector(nearest_), last_), ahead(false));
    case DirectionMode::MultiScaleAngular: {
      const MultiScaleShape own =
          multiScaleShapes(arc_.points, {at_}, arc_.settings.shape).shapes.front();
      const Point e(static_cast<double>(own.major_x),
                    static_cast<double>(own.major_y),
                    static_cast<double>(own.major_z));
      return blended(static_cast<double>(own.blend), turned(e, last_), ahead(false));
    }
    case DirectionMode::ComputedAngular:
      return blended(mu, turned(major(tensorAt(at_, radius_)), last_), ahead(false));
    }
    return Point::Zero();
  }

private:
  double
  optimalRadius(std::size_t i) const
  {
    return static_cast<double>(arc_.shapes.shapes[i].optimal_radius);
  }

  Point
  eigenvector(std::size_t i) const
  {
    const MultiScaleShape& shape = arc_.shapes.shapes[i];
    return {static_cast<double>(shape.major_x),
            static_cast<double>(shape.major_y),
            static_cast<double>(shape.major_z)};
  }

  /** d_E: mean of the eigenvectors, by w_I of the distance. */
  Point
  interpolated() const
  {
    Point sum = Point::Zero();
    double weights = 0;
    for (std::size_t i = 0; i < arc_.points.size(); ++i) {
      const double x = (arc_.points[i] - at_).norm() / radius_;
      if (x > 1)
        continue;
      const double weight = arc_.settings.interpolation_weighting(x);
      sum += weight * turned(eigenvector(i), last_);
      weights += weight;
    }
    return sum / weights;
  }

  /** d_A: direction toward the points, by w_A of the angle, and of the distance. */
  Point
  ahead(bool with_distance) const
  {
    Point sum = Point::Zero();
    double weights = 0;
    for (const Point& p : arc_.points) {
      const double distance = (p - at_).norm();
      if (distance > radius_)
        continue;
      const Point v = (p - at_) / distance;
      double weight = arc_.settings.angle_weighting((1 - v.dot(last_)) / 2);
      if (with_distance)
        weight *= arc_.settings.interpolation_weighting(distance / radius_);
      sum += weight * v;
      weights += weight;
    }
    // Points that are all behind give no direction.
    return weights > 1e-3 ? Point(sum.normalized()) : Point(Point::Zero());
  }

  /** Of trace 1. */
  Eigen::Matrix3d
  tensorAt(const Point& place, double radius) const
  {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Point& p : arc_.points) {
      const Point v = p - place;
      if (v.norm() <= radius)
        sum += arc_.settings.shape.weighting(v.norm() / radius) * v * v.transpose();
    }
    return sum / sum.trace();
  }

  Eigen::Matrix3d
  interpolatedTensor() const
  {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < arc_.points.size(); ++i) {
      const double x = (arc_.points[i] - at_).norm() / radius_;
      if (x <= 1)
        sum += arc_.settings.interpolation_weighting(x) *
               tensorAt(arc_.points[i], optimalRadius(i));
    }
    return sum;
  }

  static Point
  major(const Eigen::Matrix3d& tensor)
  {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor).eigenvectors().col(2);
  }

  const Arc& arc_;
  Point at_, last_;
  std::size_t nearest_;
  double radius_ = 0;
};

} // namespace

// Swapped modes differ by degrees; a mode and its definition by rounding.
TEST(DirectionField, EveryModeIsItsDefinitionAndNoOther)
{
  const unsigned seed = test::randomSeed();
  Arc arc(seed);
  std::mt19937 random(seed + 1);
  std::uniform_int_distribution<std::size_t> some(20, 100);
  std::normal_distribution<double> noise(0, 0.1);
  std::map<std::pair<DirectionMode, DirectionMode>, double> differences;
  const CloudNeighbors neighbors(arc.points, 1);
  for (int k = 0; k < 30; ++k) {
    const std::size_t i = some(random);
    const Point at = arc.points[i] + Point(noise(random), noise(random), noise(random));
    const double a = 0.02 * static_cast<double>(i);
    const Point last = (Point(-std::sin(a), std::cos(a), 0) +
                        2 * Point(noise(random), noise(random), noise(random)))
                           .normalized();
    const Definition definition(arc, at, last);
    for (const auto& [mode, name] : Names<DirectionMode>::table) {
      arc.settings.direction = mode;
      const DirectionField field(arc.points, arc.shapes, neighbors, arc.settings);
      const Point found = field.at(at, last, field.scaleAt(at, {}));
      // Features are stored in single precision.
      EXPECT_LT((found - definition.of(mode)).norm(), 1e-5) << name << " at " << k;
      for (const auto& [other, other_name] : Names<DirectionMode>::table) {
        double& largest = differences[{mode, other}];
        largest = std::max(largest, (found - definition.of(other)).norm());
      }
    }
  }
  for (const auto& [mode, name] : Names<DirectionMode>::table)
    for (const auto& [other, other_name] : Names<DirectionMode>::table)
      if (mode != other) {
        const double difference = differences[{mode, other}];
        EXPECT_GT(difference, 1e-3) << name << " and " << other_name;
      }
}
