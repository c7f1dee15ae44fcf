// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <linelet/tensor/eigen_features.h>
#include <linelet/tensor/shape_factors.h>

namespace {

using linelet::EigenFeatures;
using linelet::eigenFeatures;

const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

TEST(EigenFeatures, OfBallDiscAndLineAreTheExtremes)
{
  for (const double scale : {1e-6, 1.0, 1e6}) { // independent of units and size
    SCOPED_TRACE(scale);
    const EigenFeatures ball = eigenFeatures(scale * Eigen::Vector3d(1, 1, 1), up);
    EXPECT_NEAR(ball.omnivariance, 1.0 / 3, 1e-12);
    EXPECT_NEAR(ball.eigenentropy, std::log(3.0), 1e-12);
    EXPECT_NEAR(ball.surface_variation, 1.0 / 3, 1e-12);
    const EigenFeatures disc = eigenFeatures(scale * Eigen::Vector3d(0, 1, 1), up);
    EXPECT_EQ(disc.omnivariance, 0);
    EXPECT_NEAR(disc.eigenentropy, std::log(2.0), 1e-12);
    EXPECT_EQ(disc.surface_variation, 0);
    const EigenFeatures line = eigenFeatures(scale * Eigen::Vector3d(0, 0, 1), up);
    EXPECT_EQ(line.eigenentropy, 0);
  }
}

TEST(LinearityOf, IsThatOfTheEigenvalues)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (const double flat : {1.0, 0.1, 1e-3, 0.0})
    for (int k = 0; k < 50; ++k) {
      Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
      for (int point = 0; point < 6; ++point) {
        const Eigen::Vector3d v(normal(random), flat * normal(random), normal(random));
        tensor += v * v.transpose();
      }
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor);
      const Eigen::Vector3d l = solver.eigenvalues();
      EXPECT_NEAR(linelet::linearityOf(tensor), (l[2] - l[1]) / l.sum(), 1e-8);
    }
  EXPECT_EQ(linelet::linearityOf(Eigen::Matrix3d::Zero()), 0);
  EXPECT_EQ(linelet::linearityOf(Eigen::Matrix3d::Identity()), 0);
}

TEST(EigenFeatures, VerticalityIsOneOnAWallWhicheverWayItFaces)
{
  const Eigen::Vector3d values(0.01, 1, 2);
  EXPECT_NEAR(eigenFeatures(values, up).verticality, 0, 1e-12);
  EXPECT_NEAR(eigenFeatures(values, -up).verticality, 0, 1e-12);
  EXPECT_NEAR(eigenFeatures(values, Eigen::Vector3d::UnitX()).verticality, 1, 1e-12);
  EXPECT_NEAR(
      eigenFeatures(values, Eigen::Vector3d(0.8, 0, 0.6)).verticality, 0.4, 1e-12);
}

// The note on CloudCompare and jakteristics: theirs computed from ours.
TEST(EigenFeatures, GiveThoseOfRawEigenvalues)
{
  const Eigen::Vector3d l(0.02, 0.3, 1.7);
  const double sum = l.sum();
  const EigenFeatures ours = eigenFeatures(l, up);
  EXPECT_NEAR(sum * ours.omnivariance, std::cbrt(0.02 * 0.3 * 1.7), 1e-12);
  double entropy = 0;
  for (int i = 0; i < 3; ++i)
    entropy -= l[i] * std::log(l[i]);
  EXPECT_NEAR(sum * (ours.eigenentropy - std::log(sum)), entropy, 1e-12);
}

TEST(EigenFeatures, OfAnEmptyNeighborhoodAreNaN)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Eigen::Vector3d& l :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(nan, nan, nan)}) {
    EXPECT_TRUE(std::isnan(eigenFeatures(l, up).omnivariance));
    EXPECT_TRUE(std::isnan(eigenFeatures(l, up).verticality));
  }
}

} // namespace
