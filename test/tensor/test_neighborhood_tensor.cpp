// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <string>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <linelet/tensor/eigen_analysis.h>
#include <linelet/tensor/neighborhood_tensor.h>
#include <linelet/tensor/point_moments.h>
#include <linelet/tensor/shape_factors.h>

using namespace linelet;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

SymmetricTensor
tensorOf(const Eigen::Matrix3d& m)
{
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

Eigen::Matrix3d
randomRotation(boost::random::mt19937& random)
{
  boost::random::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random);
  return Eigen::Quaterniond(w, x, y, normal(random)).normalized().toRotationMatrix();
}

} // namespace

TEST(NeighborhoodTensor, IsTheWeightedMeanOfOuterProducts)
{
  // Two neighbors at distance 1 and 2 of radius 4: linear weights 3/4 and 1/2.
  const SymmetricTensor t =
      neighborhoodTensor({{2, 1, 1}, {1, 1, 3}}, Point(1, 1, 1), 4, Kernel::Linear);
  EXPECT_DOUBLE_EQ(t.xx, 0.75 / 1.25);
  EXPECT_DOUBLE_EQ(t.zz, 0.5 * 4 / 1.25);
  EXPECT_EQ(t.yy, 0);
  EXPECT_EQ(t.xy, 0);
  EXPECT_EQ(t.xz, 0);
  EXPECT_EQ(t.yz, 0);
  EXPECT_DOUBLE_EQ(t.trace(), 2.75 / 1.25);
}

TEST(PointMoments, GiveTheTensorAroundTheMean)
{
  // Corners of a box of 2 x 4 x 6 around (3, 5, 7): variances are squared half edges.
  PointMoments box, none;
  for (int corner = 0; corner < 8; ++corner)
    box.add({corner & 1 ? 4.0 : 2.0, corner & 2 ? 7.0 : 3.0, corner & 4 ? 10.0 : 4.0});
  const SymmetricTensor t = box.covariance();
  EXPECT_EQ(t.matrix(), Eigen::Matrix3d(Eigen::Vector3d(1, 4, 9).asDiagonal()));

  // Two points: the outer product of half their difference.
  PointMoments pair;
  pair.add({1, 0, -1});
  pair.add({3, 4, 5});
  Eigen::Matrix3d expected;
  expected << 1, 2, 3, 2, 4, 6, 3, 6, 9;
  EXPECT_EQ(pair.covariance().matrix(), expected);

  EXPECT_TRUE(std::isnan(none.covariance().trace()));
}

// The form in the publications of 2012.
TEST(NeighborhoodTensor, DividedByTheCountIsTheMeanOfWeightedOuterProducts)
{
  const SymmetricTensor t = neighborhoodTensor(
      {{2, 1, 1}, {1, 1, 3}}, Point(1, 1, 1), 4, Kernel::Linear, Normalization::Count);
  EXPECT_DOUBLE_EQ(t.xx, 0.75 / 2);
  EXPECT_DOUBLE_EQ(t.zz, 0.5 * 4 / 2);
  EXPECT_DOUBLE_EQ(t.trace(), 2.75 / 2);
}

// Every neighbor then counts by its direction alone, and the point itself not at all.
TEST(NeighborhoodTensor, OfInverseSquaredDistanceIsTheSumOfDirections)
{
  const Points neighbors = {{0, 0, 0}, {1e-9, 0, 0}, {0, 3, 0}, {0, 0, -2}};
  const SymmetricTensor t = neighborhoodTensor(neighbors,
                                               Point::Zero(),
                                               4,
                                               Kernel::InverseSquaredDistance,
                                               Normalization::Count);
  for (const double entry : {t.xx, t.yy, t.zz})
    EXPECT_NEAR(entry, 16.0 / 4, 1e-12); // r^2 over the count
  EXPECT_TRUE(std::isnan(
      neighborhoodTensor({{1, 1, 1}}, Point(1, 1, 1), 4, Kernel::InverseDistance).xx));
}

TEST(NeighborhoodTensor, IsNaNWithoutWeight)
{
  EXPECT_TRUE(std::isnan(
      neighborhoodTensor({}, Point::Zero(), 1, Kernel::Const, Normalization::Count)
          .xx));
  EXPECT_TRUE(std::isnan(neighborhoodTensor({}, Point::Zero(), 1, Kernel::Const).xx));
  // Every neighbor on the rim, where a compact kernel is 0.
  EXPECT_TRUE(
      std::isnan(neighborhoodTensor({{1, 0, 0}}, Point::Zero(), 1, Kernel::Linear).yz));
  // A neighborhood of zero extent is a single place, whose tensor is 0.
  EXPECT_EQ(
      neighborhoodTensor(Points(3, Point(1, 2, 3)), Point(1, 2, 3), 0, Kernel::Linear)
          .trace(),
      0);
}

TEST(EigenAnalysis, FindsKnownEigenvaluesOfWireLikeTensors)
{
  // The closed form in double is off by 3e-9 here, float by more than the value itself.
  boost::random::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d values(1e-5, 3e-5, 8e-2);
    const Eigen::Matrix3d axes = randomRotation(random);
    const EigenSystem system =
        eigenAnalysis(tensorOf(axes * values.asDiagonal() * axes.transpose()));
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(system.values[k], values[k], 1e-10 * values[k]);
      EXPECT_NEAR(std::abs(system.vectors.col(k).dot(axes.col(k))), 1, 1e-10);
    }
  }
}

TEST(EigenAnalysis, VectorsAreOrthonormalWithTheLargestComponentPositive)
{
  boost::random::mt19937 random(2);
  boost::random::normal_distribution<double> normal;
  for (int i = 0; i < 2000; ++i) {
    SymmetricTensor tensor;
    // From rank 1 to 3, of all sizes.
    for (int k = 0; k <= i % 4; ++k)
      tensor.add(std::pow(10.0, i % 60 - 30),
                 Point(normal(random), normal(random), normal(random)));
    const EigenSystem system = eigenAnalysis(tensor);
    EXPECT_TRUE((system.vectors.transpose() * system.vectors).isIdentity(1e-12));
    EXPECT_LE(system.values[0], system.values[1]);
    EXPECT_LE(system.values[1], system.values[2]);
    EXPECT_GE(system.values[0], 0);
    EXPECT_NEAR(system.values.sum(), tensor.trace(), 1e-12 * tensor.trace());
    const Eigen::Vector3d residual =
        tensor.matrix() * system.major() - system.values[2] * system.major();
    EXPECT_LE(residual.norm(), 1e-12 * system.values[2]);
    for (int column = 0; column < 3; ++column) {
      const Eigen::Vector3d v = system.vectors.col(column);
      EXPECT_EQ(v.maxCoeff(), v.cwiseAbs().maxCoeff());
    }
  }
}

TEST(EigenAnalysis, HandlesDegenerateTensors)
{
  EXPECT_EQ(eigenAnalysis({}).values, Eigen::Vector3d::Zero());
  EXPECT_TRUE(eigenAnalysis({}).vectors.allFinite());
  const EigenSystem ball = eigenAnalysis({2, 0, 0, 2, 0, 2});
  EXPECT_EQ(ball.values, Eigen::Vector3d::Constant(2));
  EXPECT_TRUE((ball.vectors.transpose() * ball.vectors).isIdentity());
  EXPECT_TRUE(eigenAnalysis({unknown, 0, 0, 1, 0, 1}).values.hasNaN());
  EXPECT_TRUE(eigenAnalysis({1, 0, 0, 1, unknown, 1}).vectors.hasNaN());
  EXPECT_TRUE(eigenAnalysis({std::numeric_limits<double>::infinity()}).values.hasNaN());
}

TEST(ShapeFactors, OfALineADiscABallAndBetween)
{
  const ShapeFactors line = shapeFactors({0, 0, 3});
  EXPECT_EQ(line.linearity, 1);
  EXPECT_EQ(line.planarity, 0);
  EXPECT_EQ(line.sphericity, 0);
  const ShapeFactors disc = shapeFactors({0, 4, 4});
  EXPECT_EQ(disc.linearity, 0);
  EXPECT_EQ(disc.planarity, 1);
  const ShapeFactors ball = shapeFactors({5, 5, 5});
  EXPECT_EQ(ball.sphericity, 1);
  const ShapeFactors mixed = shapeFactors({1, 3, 6}); // L = 10
  EXPECT_DOUBLE_EQ(mixed.linearity, 0.3);
  EXPECT_DOUBLE_EQ(mixed.planarity, 0.4);
  EXPECT_DOUBLE_EQ(mixed.sphericity, 0.3);
}

TEST(ShapeFactors, AreNaNForCoincidentPoints)
{
  for (const Eigen::Vector3d& values :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(unknown, unknown, unknown)}) {
    EXPECT_TRUE(std::isnan(shapeFactors(values).linearity));
    EXPECT_TRUE(std::isnan(shapeFactors(values).planarity));
    EXPECT_TRUE(std::isnan(shapeFactors(values).sphericity));
  }
  // The rounding of coincident points 100 m away is not a shape; a millimeter is.
  EXPECT_TRUE(std::isnan(shapeFactors({0, 0, 1e-28}, 100).linearity));
  EXPECT_EQ(shapeFactors({0, 0, 1e-6}, 100).linearity, 1);
}
