// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <linelet/features/tensor_estimation.h>

namespace linelet::test {

using Records = std::vector<PointDistributionTensor>;

inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinite = std::numeric_limits<double>::infinity();

/** \brief A wire, a patch of ground and a bush, on a lattice of 1/256 so that sums with
 * large offsets are exact. */
inline Points
scene(std::size_t count, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::normal_distribution<double> normal;
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = normal(random), b = normal(random), c = normal(random);
    const Point point = i % 3 == 0   ? Point(2 * a, 0.02 * b, 3 + 0.02 * c)
                        : i % 3 == 1 ? Point(2 * a, 2 * b, 0.05 * c)
                                     : Point(1 + a, 1 + b, 1 + c);
    points.push_back((256 * point).array().round().matrix() / 256);
  }
  return points;
}

inline TensorSettings
withRadius(double radius,
           const Weighting& weighting = Kernel::FermiDirac1,
           Centroid centroid = Centroid::QueryPoint)
{
  TensorSettings settings;
  settings.radius = radius;
  settings.weighting = weighting;
  settings.centroid = centroid;
  return settings;
}

/** \brief The fixed point of Weiszfeld's iteration from the mean, by brute force. */
inline Point
patientMedian(const Points& points, double radius, const Weighting& weighting)
{
  Point x = Point::Zero();
  for (const Point& point : points)
    x += point / static_cast<double>(points.size());
  for (int i = 0; i < 30000; ++i) {
    const Point before = x;
    Point sum = Point::Zero();
    double total = 0;
    for (const Point& point : points) {
      const double distance = std::max((point - x).norm(), 1e-12);
      const double weight = weighting(distance / radius) / distance;
      sum += weight * point;
      total += weight;
    }
    if (!(total > 0))
      break;
    x = sum / total;
    if ((x - before).norm() < 1e-15)
      break;
  }
  return x;
}

struct Expected {
  std::size_t neighbors = 0;
  Eigen::Vector3d shape = Eigen::Vector3d::Constant(not_known);
};

/** \brief The definition, literally. */
inline Expected
bruteForce(const Points& surface, const Point& p, const TensorSettings& s)
{
  Points found;
  for (const Point& point : surface)
    if ((point - p).squaredNorm() <= s.radius * s.radius)
      found.push_back(point);
  Expected expected;
  expected.neighbors = found.size();
  if (found.empty())
    return expected;

  Point c = p;
  if (s.centroid == Centroid::Mean || s.centroid == Centroid::WeightedMean) {
    const Weighting weighting =
        s.centroid == Centroid::Mean ? Weighting(Kernel::Const) : s.centroid_weighting;
    Point sum = Point::Zero();
    double total = 0;
    for (const Point& point : found) {
      const double weight = weighting((point - p).norm() / s.radius);
      sum += weight * point;
      total += weight;
    }
    c = sum / total;
  }
  else if (s.centroid != Centroid::QueryPoint)
    c = patientMedian(found,
                      s.radius,
                      s.centroid == Centroid::Median ? Weighting(Kernel::Const)
                                                     : s.centroid_weighting);

  Eigen::Matrix3d t = Eigen::Matrix3d::Zero();
  double total = 0;
  for (const Point& point : found) {
    const Point v = point - c;
    const double weight = s.weighting(v.norm() / s.radius);
    t += weight * v * v.transpose();
    total += weight;
  }
  const Eigen::Vector3d l =
      Eigen::JacobiSVD<Eigen::Matrix3d>(t / total).singularValues();
  const double sum = l.sum();
  if (total > 0 && sum > 1e-20)
    expected.shape = Eigen::Vector3d(l[0] - l[1], 2 * (l[1] - l[2]), 3 * l[2]) / sum;
  return expected;
}

inline double
shapeDifference(const PointDistributionTensor& record, const Eigen::Vector3d& shape)
{
  if (std::isnan(record.linearity) || std::isnan(shape[0]))
    return std::isnan(record.linearity) == std::isnan(shape[0]) ? 0 : infinite;
  return std::max({std::abs(record.linearity - shape[0]),
                   std::abs(record.planarity - shape[1]),
                   std::abs(record.sphericity - shape[2])});
}

inline Eigen::Vector3d
shapeOf(const PointDistributionTensor& record)
{
  return {record.linearity, record.planarity, record.sphericity};
}

inline Point
majorOf(const PointDistributionTensor& record)
{
  return {record.major_x, record.major_y, record.major_z};
}

inline Point
normalOf(const PointDistributionTensor& record)
{
  return {record.normal_x, record.normal_y, record.normal_z};
}

inline bool
sameBits(const Records& a, const Records& b)
{
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(a.front())) == 0;
}

inline PointDistributionTensor
tensorAt(const Points& surface, const Point& query, const TensorSettings& settings)
{
  return estimateTensors(surface, {query}, settings).front();
}

} // namespace linelet::test
