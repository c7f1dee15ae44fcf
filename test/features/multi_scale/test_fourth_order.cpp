// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <linelet/features/fourth_order.h>

#include "multi_scale_clouds.h"

namespace {

using linelet::FourthOrderTensor;
using linelet::SymmetricFourthOrderTensor;
using linelet::SymmetricTensor;

constexpr unsigned seed = 21;

/// All 81 components, computed naively.
using Plain = std::array<std::array<std::array<std::array<double, 3>, 3>, 3>, 3>;

template <class Visit>
void
forAll(Visit visit)
{
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          visit(i, j, k, l);
}

std::vector<SymmetricTensor>
randomTensors(std::mt19937& engine, int count)
{
  std::vector<SymmetricTensor> tensors(static_cast<std::size_t>(count));
  const auto number = [&] { return static_cast<double>(engine()) / 2147483648.0 - 1; };
  for (SymmetricTensor& tensor : tensors)
    for (int n = 0; n < 5; ++n) {
      const double x = number(), y = 0.3 * number(), z = 0.1 * number();
      tensor.add(1, {x, y, z});
    }
  return tensors;
}

double
linearity(const SymmetricTensor& tensor)
{
  const Eigen::Vector3d l =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor.matrix()).eigenvalues();
  return (l[2] - l[1]) / l.sum();
}

Eigen::Matrix3d
rotation()
{
  return Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).matrix();
}

TEST(FourthOrder, MandelKeepsTheDoubleContraction)
{
  std::mt19937 engine(seed);
  const auto tensors = randomTensors(engine, 2);
  const Eigen::Matrix3d a = tensors[0].matrix(), b = tensors[1].matrix();
  EXPECT_NEAR(linelet::mandel(a).dot(linelet::mandel(b)), (a * b).trace(), 1e-12);
  EXPECT_LT((linelet::fromMandel(linelet::mandel(a)) - a).norm(), 1e-15);
}

TEST(FourthOrder, IsTheWeightedMeanOfOuterProducts)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 engine(seed);
  for (int round = 0; round < 20; ++round) {
    const auto tensors = randomTensors(engine, 6);
    Plain plain{};
    double total = 0;
    for (const SymmetricTensor& tensor : tensors) {
      const double w = linearity(tensor);
      const Eigen::Matrix3d t = tensor.matrix();
      total += w;
      forAll([&](int i, int j, int k, int l) {
        plain[i][j][k][l] += w * t(i, j) * t(k, l);
      });
    }
    const FourthOrderTensor tensor = linelet::fourthOrderTensor(tensors);
    const SymmetricFourthOrderTensor symmetric(tensor);
    forAll([&](int i, int j, int k, int l) {
      ASSERT_NEAR(tensor(i, j, k, l), plain[i][j][k][l] / total, 1e-12);
      // Mean over all 24 orders of the indices.
      std::array<int, 4> order = {0, 1, 2, 3};
      const std::array<int, 4> index = {i, j, k, l};
      double mean = 0;
      do
        mean +=
            plain[index[order[0]]][index[order[1]]][index[order[2]]][index[order[3]]];
      while (std::next_permutation(order.begin(), order.end()));
      ASSERT_NEAR(symmetric(i, j, k, l), mean / 24 / total, 1e-12);
    });
  }
}

TEST(FourthOrder, Symmetries)
{
  std::mt19937 engine(seed);
  const FourthOrderTensor t = linelet::fourthOrderTensor(randomTensors(engine, 5));
  const SymmetricFourthOrderTensor s(t);
  forAll([&](int i, int j, int k, int l) {
    EXPECT_EQ(t(i, j, k, l), t(j, i, k, l));
    EXPECT_EQ(t(i, j, k, l), t(i, j, l, k));
    EXPECT_DOUBLE_EQ(t(i, j, k, l), t(k, l, i, j));
    EXPECT_EQ(s(i, j, k, l), s(k, j, i, l));
    EXPECT_EQ(s(i, j, k, l), s(l, j, k, i));
  });
}

TEST(FourthOrder, LayoutsHoldAllThereIs)
{
  std::mt19937 engine(seed);
  const FourthOrderTensor t = linelet::fourthOrderTensor(randomTensors(engine, 5));
  const FourthOrderTensor again = FourthOrderTensor::fromComponents(t.components());
  EXPECT_LT((again.mandelMatrix() - t.mandelMatrix()).norm(), 1e-14);

  const SymmetricFourthOrderTensor s(t);
  const auto& c = s.components();
  EXPECT_EQ(c[0], s(0, 0, 0, 0));
  EXPECT_EQ(c[1], s(0, 0, 0, 1));
  EXPECT_EQ(c[2], s(2, 0, 0, 0));
  EXPECT_EQ(c[3], s(0, 1, 0, 1));
  EXPECT_EQ(c[8], s(0, 1, 2, 2));
  EXPECT_EQ(c[10], s(1, 1, 1, 1));
  EXPECT_EQ(c[12], s(2, 1, 2, 1));
  EXPECT_EQ(c[14], s(2, 2, 2, 2));
  const SymmetricFourthOrderTensor twice(s.expanded());
  for (std::size_t n = 0; n < 15; ++n)
    EXPECT_NEAR(twice.components()[n], c[n], 1e-14);
}

TEST(FourthOrder, RotatesWithItsPoints)
{
  std::mt19937 engine(seed);
  const Eigen::Matrix3d q = rotation();
  const auto tensors = randomTensors(engine, 4);
  std::vector<SymmetricTensor> turned;
  for (const SymmetricTensor& tensor : tensors) {
    const Eigen::Matrix3d m = q * tensor.matrix() * q.transpose();
    turned.push_back({m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)});
  }
  const FourthOrderTensor t = linelet::fourthOrderTensor(tensors);
  const FourthOrderTensor of_turned = linelet::fourthOrderTensor(turned);
  EXPECT_LT((t.rotated(q).mandelMatrix() - of_turned.mandelMatrix()).norm(), 1e-12);
  // The law itself, index by index.
  const FourthOrderTensor rotated = t.rotated(q);
  forAll([&](int i, int j, int k, int l) {
    double sum = 0;
    forAll([&](int a, int b, int c, int d) {
      sum += q(i, a) * q(j, b) * q(k, c) * q(l, d) * t(a, b, c, d);
    });
    ASSERT_NEAR(rotated(i, j, k, l), sum, 1e-12);
  });
  // Full symmetrization and rotation commute.
  const auto first = SymmetricFourthOrderTensor(rotated).components();
  const auto second =
      SymmetricFourthOrderTensor(SymmetricFourthOrderTensor(t).expanded().rotated(q))
          .components();
  for (std::size_t n = 0; n < 15; ++n)
    EXPECT_NEAR(first[n], second[n], 1e-12);
}

TEST(FourthOrder, EigenTensors)
{
  std::mt19937 engine(seed);
  const FourthOrderTensor t = linelet::fourthOrderTensor(randomTensors(engine, 5));
  const auto eigen = t.eigenTensors();
  for (std::size_t n = 0; n < 6; ++n) {
    const Eigen::Matrix3d& e = eigen.tensors[n];
    EXPECT_NEAR(e.norm(), 1, 1e-12);
    EXPECT_LT((e - e.transpose()).norm(), 1e-14);
    EXPECT_GE(e.trace(), 0);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        double applied = 0; // T : e = value e
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l)
            applied += t(i, j, k, l) * e(k, l);
        EXPECT_NEAR(applied, eigen.values[n] * e(i, j), 1e-12);
      }
    if (n > 0) {
      EXPECT_GE(eigen.values[n], eigen.values[n - 1]);
    }
  }
}

TEST(FourthOrder, OneScaleIsItsOwnMajorEigenTensor)
{
  std::mt19937 engine(seed);
  const auto tensors = randomTensors(engine, 1);
  const Eigen::Matrix3d t = tensors[0].matrix();
  const auto eigen = linelet::fourthOrderTensor(tensors).eigenTensors();
  EXPECT_LT((eigen.major() - t / t.norm()).norm(), 1e-12);
  EXPECT_NEAR(eigen.values[5], t.squaredNorm(), 1e-12);
  // Along a direction it is the square of the quadratic form.
  const SymmetricFourthOrderTensor s(linelet::fourthOrderTensor(tensors));
  const Eigen::Vector3d v(0.3, -0.5, 0.8);
  EXPECT_NEAR(s.along(v), std::pow(v.dot(t * v), 2), 1e-12);
}

TEST(FourthOrder, WeightsChooseTheScales)
{
  const SymmetricTensor line{1, 0, 0, 0, 0, 0}, disc{0, 0, 0, 1, 0, 1};
  using linelet::ScaleWeight;
  const auto major = [&](ScaleWeight weight) -> Eigen::Matrix3d {
    return linelet::fourthOrderTensor({line, disc}, weight).eigenTensors().major();
  };
  EXPECT_NEAR(major(ScaleWeight::Linearity)(0, 0), 1, 1e-12);
  EXPECT_NEAR(major(ScaleWeight::Planarity)(1, 1), std::sqrt(0.5), 1e-12);
  // Equal weights: the disc is the larger tensor.
  EXPECT_NEAR(major(ScaleWeight::Uniform)(0, 0), 0, 1e-12);
  EXPECT_TRUE(std::isnan(major(ScaleWeight::Sphericity)(0, 0))); // neither is round
}

TEST(FourthOrder, ScalesWithoutTensorTakeNoPart)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::mt19937 engine(seed);
  auto tensors = randomTensors(engine, 3);
  const auto clean = linelet::fourthOrderTensor(tensors);
  tensors.insert(tensors.begin(), SymmetricTensor{nan, nan, nan, nan, nan, nan});
  tensors.push_back({});
  EXPECT_EQ(linelet::fourthOrderTensor(tensors).mandelMatrix(), clean.mandelMatrix());
  EXPECT_TRUE(std::isnan(linelet::fourthOrderTensor({})(0, 0, 0, 0)));
  EXPECT_TRUE(std::isnan(linelet::fourthOrderTensor({}).eigenTensors().values[5]));
}

TEST(FourthOrder, OfTheNeighborhoodsOfACloud)
{
  // On a straight line every scale has the same shape: the major eigentensor is d (x)
  // d.
  linelet::Points line;
  const Eigen::Vector3d d = Eigen::Vector3d(1, 2, -2) / 3;
  for (int i = -200; i <= 200; ++i)
    line.push_back(0.05 * i * d);
  const auto tensors =
      linelet::fourthOrderTensors(line, {line[200], line[120], line[0]});
  ASSERT_EQ(tensors.size(), 3u);
  for (const FourthOrderTensor& tensor : tensors)
    EXPECT_LT((tensor.eigenTensors().major() - d * d.transpose()).norm(), 1e-9);
  const auto alone = linelet::fourthOrderTensors(line, {linelet::Point(99, 0, 0)});
  EXPECT_TRUE(std::isnan(alone[0](0, 0, 0, 0)));
}

/// A wire over ground, and a query far from both: the grid engine agrees with the sweep
/// in double, relative to the largest component.
TEST(FourthOrder, SameOnBothEngines)
{
  linelet::Points cloud = linelet_test::randomPoints(3000, seed, {30, 20, 0.1});
  linelet_test::addSegment(cloud, {0, 5, 8}, {30, 12, 8}, 0.05);
  linelet::Points queries = cloud;
  queries.push_back({0, 0, 1000});
  linelet::MultiScaleSettings settings;
  settings.max_radius = 5;
  for (const linelet::Kernel kernel :
       {linelet::Kernel::Const, linelet::Kernel::FermiDirac1}) {
    settings.weighting = kernel;
    const auto of = [&](linelet::ScaleEngine engine) {
      settings.engine = engine;
      return linelet::fourthOrderTensors(
          cloud, queries, settings, linelet::ScaleWeight::Linearity);
    };
    const auto sweep = of(linelet::ScaleEngine::Sweep),
               grid = of(linelet::ScaleEngine::Grid);
    ASSERT_EQ(sweep.size(), grid.size());
    EXPECT_FALSE(grid.back().mandelMatrix().allFinite());
    EXPECT_FALSE(sweep.back().mandelMatrix().allFinite());
    for (std::size_t i = 0; i + 1 < queries.size(); ++i) {
      const double size = sweep[i].mandelMatrix().cwiseAbs().maxCoeff();
      ASSERT_GT(size, 0) << i;
      ASSERT_LT(
          (grid[i].mandelMatrix() - sweep[i].mandelMatrix()).cwiseAbs().maxCoeff(),
          1e-4 * size)
          << i << ' ' << nameOf(kernel);
    }
  }
}

} // namespace
