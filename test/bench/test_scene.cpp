// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <bench/scenes/scene.h>

namespace {

using namespace linelet;
using namespace linelet::bench;

SceneScan
make(SceneKind kind, std::uint32_t seed, double density = 0)
{
  SceneSettings settings;
  settings.kind = kind;
  settings.seed = seed;
  settings.density = density;
  return simulateScene(settings);
}

double
lengthOf(const SceneWire& wire)
{
  double sum = 0;
  for (std::size_t i = 1; i < wire.points.size(); ++i)
    sum += (wire.points[i] - wire.points[i - 1]).norm();
  return sum;
}

/** Places of the points of class 14 whose wire is known. */
std::vector<std::size_t>
pointsOnWires(const SceneScan& scan)
{
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < scan.points.size(); ++i)
    if (scan.wire[i] >= 0)
      places.push_back(i);
  return places;
}

/** Distance of a point from a wire and its straight continuation, by brute force: where
 * a wire leaves the scan at an angle, noise carries points beyond its end. */
double
distanceToWire(const Point& p, const SceneWire& wire)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < wire.points.size(); ++i) {
    const Point a = wire.points[i - 1], edge = wire.points[i] - a;
    const double low = i == 1 ? -1 : 0, high = i + 1 == wire.points.size() ? 2 : 1;
    const double t = std::clamp((p - a).dot(edge) / edge.squaredNorm(), low, high);
    least = std::min(least, (p - a - t * edge).norm());
  }
  return least;
}

class AllScenes : public testing::TestWithParam<SceneKind> {};

bool
isEmpty(SceneKind kind)
{
  return kind == SceneKind::ClutterEmpty || kind == SceneKind::MountainEmpty ||
         kind == SceneKind::TownEmpty || kind == SceneKind::ForestEmpty;
}

TEST_P(AllScenes, SizeClassesAndTruth)
{
  const SceneScan scan = make(GetParam(), 5);
  const std::size_t n = scan.points.size();
  EXPECT_GE(n, 50000U);
  EXPECT_LE(n, 500000U);
  ASSERT_EQ(scan.classification.size(), n);
  ASSERT_EQ(scan.return_number.size(), n);
  ASSERT_EQ(scan.number_of_returns.size(), n);
  ASSERT_EQ(scan.strip.size(), n);
  ASSERT_EQ(scan.wire.size(), n);
  EXPECT_EQ(scan.wires.empty(), isEmpty(GetParam()));
  const std::vector<std::uint8_t> known = {1, 2, 5, 6, 7, 14, 15, 16};
  for (std::size_t i = 0; i < n; ++i) {
    ASSERT_TRUE(scan.points[i].allFinite());
    ASSERT_TRUE(std::find(known.begin(), known.end(), scan.classification[i]) !=
                known.end());
    ASSERT_GE(scan.return_number[i], 1);
    ASSERT_LE(scan.return_number[i], scan.number_of_returns[i]);
    ASSERT_LT(scan.wire[i], static_cast<std::int32_t>(scan.wires.size()));
    if (scan.wire[i] >= 0) {
      ASSERT_EQ(scan.classification[i], 14);
    }
    if (isEmpty(GetParam())) {
      ASSERT_NE(scan.classification[i], 14);
    }
  }
  if (!isEmpty(GetParam())) {
    EXPECT_GT(pointsOnWires(scan).size(), 300U);
  }
}

/** Points of a wire lie where the truth says, up to noise. */
TEST_P(AllScenes, WirePointsLieOnTheirWire)
{
  const SceneScan scan = make(GetParam(), 6);
  for (const std::size_t i : pointsOnWires(scan)) {
    const SceneWire& wire = scan.wires[static_cast<std::size_t>(scan.wire[i])];
    // Six standard deviations; straight pieces of 2 m; millimeters in the file.
    ASSERT_LT(distanceToWire(scan.points[i], wire),
              wire.bundle_radius + scan.aside + 6 * wire.noise + 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds,
                         AllScenes,
                         testing::ValuesIn([] {
                           std::vector<SceneKind> kinds;
                           for (const auto& entry : Names<SceneKind>::table)
                             kinds.push_back(entry.first);
                           return kinds;
                         }()),
                         [](const auto& info) {
                           std::string name(nameOf(info.param));
                           name.erase(std::remove(name.begin(), name.end(), '-'),
                                      name.end());
                           return name;
                         });

TEST(Scene, TheSameSeedIsTheSameScene)
{
  const SceneScan one = make(SceneKind::Street, 3), two = make(SceneKind::Street, 3);
  ASSERT_EQ(one.points.size(), two.points.size());
  EXPECT_TRUE(std::equal(one.points.begin(), one.points.end(), two.points.begin()));
  EXPECT_EQ(one.classification, two.classification);
  const SceneScan other = make(SceneKind::Street, 4);
  EXPECT_NE(one.points.size(), other.points.size());
  EXPECT_NE(one.shift, other.shift);
}

/** Density, points per meter and noise are as requested. */
TEST(Scene, SamplingAsAsked)
{
  SceneSettings settings;
  settings.kind = SceneKind::Helicopter;
  settings.density = 40;
  settings.wire_density = 10;
  settings.noise = 0.04;
  const SceneScan scan = simulateScene(settings);
  double length = 0;
  for (const SceneWire& wire : scan.wires)
    if (wire.kind == WireKind::Conductor)
      length += lengthOf(wire);
  std::size_t count = 0, single = 0;
  double squares = 0;
  for (const std::size_t i : pointsOnWires(scan)) {
    const SceneWire& wire = scan.wires[static_cast<std::size_t>(scan.wire[i])];
    if (wire.kind != WireKind::Conductor)
      continue;
    ++count;
    if (wire.conductors == 1) {
      const double d = distanceToWire(scan.points[i], wire);
      squares += d * d;
      ++single;
    }
  }
  // Some stretches are hidden, and objects above intercept pulses.
  EXPECT_GT(static_cast<double>(count) / length, 7.5);
  EXPECT_LT(static_cast<double>(count) / length, 11);
  ASSERT_GT(single, 1000U);
  // Two axes across the wire carry the noise.
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(single) / 2), 0.04, 0.003);
  // First returns are pulses: 170 m by 32 m.
  const auto first =
      std::count(scan.return_number.begin(), scan.return_number.end(), 1);
  EXPECT_NEAR(static_cast<double>(first) / (170 * 32), 40, 3);
}

/** All points of a quad bundle fill its width. */
TEST(Scene, QuadBundles)
{
  const SceneScan scan = make(SceneKind::Quad, 9);
  double length = 0, farthest = 0;
  std::size_t count = 0;
  for (const SceneWire& wire : scan.wires)
    if (wire.conductors == 4)
      length += lengthOf(wire);
  ASSERT_GT(length, 2000);
  for (const std::size_t i : pointsOnWires(scan)) {
    const SceneWire& wire = scan.wires[static_cast<std::size_t>(scan.wire[i])];
    if (wire.conductors != 4)
      continue;
    ++count;
    // Four on a square of 0.4 to 0.5 m.
    EXPECT_GT(wire.bundle_radius, 0.28);
    EXPECT_LT(wire.bundle_radius, 0.36);
    farthest = std::max(farthest, distanceToWire(scan.points[i], wire));
  }
  EXPECT_GT(static_cast<double>(count) / length, 1.5);
  EXPECT_LT(static_cast<double>(count) / length, 5);
  EXPECT_GT(farthest, 0.28);
}

TEST(Scene, WaterReturnsNothing)
{
  const SceneScan scan = make(SceneKind::River, 2);
  const auto longest = std::max_element(
      scan.wires.begin(), scan.wires.end(), [](const auto& a, const auto& b) {
        return lengthOf(a) < lengthOf(b);
      });
  ASSERT_GT(lengthOf(*longest), 700);
  const Point middle = longest->points[longest->points.size() / 2];
  for (std::size_t i = 0; i < scan.points.size(); ++i)
    if (scan.classification[i] == 2) {
      ASSERT_GT((scan.points[i] - middle).head<2>().norm(), 200);
    }
}

/** Wires in a forest are partly hidden. */
TEST(Scene, TheForestHidesWires)
{
  double hidden = 0, all = 0;
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    const SceneScan scan = make(SceneKind::Forest, seed);
    for (std::size_t w = 0; w < scan.wires.size(); ++w) {
      const SceneWire& wire = scan.wires[w];
      Points own;
      for (const std::size_t i : pointsOnWires(scan))
        if (scan.wire[i] == static_cast<std::int32_t>(w))
          own.push_back(scan.points[i]);
      for (const Point& p : wire.points) {
        ++all;
        if (std::none_of(own.begin(), own.end(), [&](const Point& q) {
              return (p - q).norm() < 2;
            }))
          ++hidden;
      }
    }
  }
  EXPECT_GT(hidden / all, 0.2);
  EXPECT_LT(hidden / all, 0.5);
}

/** Slopes are as documented: the ground rises at 30 to 40 degrees. */
TEST(Scene, MountainsAreSteep)
{
  const SceneScan scan = make(SceneKind::MountainEmpty, 3, 1);
  Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
  Point right = Point::Zero();
  for (std::size_t i = 0; i < scan.points.size(); ++i)
    if (scan.classification[i] == 2) {
      const Point row(scan.points[i].x(), scan.points[i].y(), 1);
      sums += row * row.transpose();
      right += scan.points[i].z() * row;
    }
  const Point plane = sums.ldlt().solve(right);
  const double slope = std::atan(plane.head<2>().norm()) * 180 / M_PI;
  EXPECT_GT(slope, 25);
  EXPECT_LT(slope, 45);
}

TEST(Scene, SettingsOutOfRange)
{
  const auto refused = [](double density, double wire, double noise) {
    SceneSettings s;
    s.density = density;
    s.wire_density = wire;
    s.noise = noise;
    EXPECT_THROW(simulateScene(s), std::invalid_argument);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused(-1, 0, 0);
  refused(1e6, 0, 0);
  refused(nan, 0, 0);
  refused(0, -1, 0);
  refused(0, nan, 0);
  refused(0, 0, -0.1);
  refused(0, 0, nan);
}

} // namespace
