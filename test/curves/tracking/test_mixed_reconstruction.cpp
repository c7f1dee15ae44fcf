// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Scenes with ground, a roof, crowns and wires, and the same without wires.
#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <linelet/curves/reconstruct_curves.h>
#include <linelet/io/cloud.h>
#include <linelet/io/point_file.h>

#include "network_distance.h"
#include "test_data.h"

using namespace linelet;

namespace {

constexpr int wires = 3;

Point
wireAt(int wire, double x)
{
  return {x, 4.0 * wire, 12 + 0.002 * (x - 40) * (x - 40)};
}

/** \brief 80 x 40, ground with 8 points per square unit, crowns beside
 * \a with_wires. */
Points
scene(unsigned seed, bool with_wires)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> noise(0, 0.03);
  Points points;
  for (int k = 0; k < 25600; ++k)
    points.emplace_back(80 * unit(random), 40 * unit(random) - 20, noise(random));
  for (int k = 0; k < 1500; ++k) { // a roof
    const double x = 10 * unit(random), y = 8 * unit(random);
    points.emplace_back(
        50 + x, -18 + y, 7 - 0.6 * std::abs(y - 4) + 0.5 * noise(random));
  }
  for (int tree = 0; tree < 14; ++tree) {
    const Point center(80 * unit(random), 14 + 5 * unit(random), 7);
    for (int k = 0; k < 900; ++k) {
      const Point direction =
          Point(unit(random) - .5, unit(random) - .5, unit(random) - .5).normalized();
      points.emplace_back(center + 3.0 * std::cbrt(unit(random)) * direction);
    }
  }
  for (int wire = 0; with_wires && wire < wires; ++wire)
    for (int k = 0; k < 200; ++k)
      points.emplace_back(wireAt(wire, 80 * unit(random)) +
                          Point(0, noise(random), noise(random)));
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

/** \brief Share of the wires within \a tolerance of \a network, both moved by
 * \a move. */
double
covered(const CurveNetwork& network, const Eigen::Affine3d& move, double tolerance)
{
  int near = 0, all = 0;
  for (int wire = 0; wire < wires; ++wire)
    for (double x = 0.5; x < 80; x += 0.5, ++all)
      near += distanceTo(network, move * wireAt(wire, x)) <= tolerance;
  return static_cast<double>(near) / all;
}

TEST(MixedReconstruction, FindsTheWiresOverGroundRoofAndCrowns)
{
  for (const unsigned seed : {1U, 2U}) {
    SCOPED_TRACE(seed);
    const CurveNetwork network = reconstructCurves(scene(seed, true));
    EXPECT_GE(covered(network, Eigen::Affine3d::Identity(), 0.1), 0.97);
    // Crowns of scattered points have no branches: anything found there is wrong.
    EXPECT_LE(length(network), 1.1 * wires * 81.5);
    for (const Curve& curve : network.curves) {
      EXPECT_GT(curve.evidence, 20);
      EXPECT_TRUE(std::isfinite(curve.noise) && std::isfinite(curve.density));
    }
  }
}

TEST(MixedReconstruction, FindsNothingWithoutCurves)
{
  for (const unsigned seed : {3U, 4U}) {
    SCOPED_TRACE(seed);
    EXPECT_LE(length(reconstructCurves(scene(seed, false))), 10);
  }
}

TEST(MixedReconstruction, FewPointsOfASceneAreNotACloudOfCurves)
{
  // Without its ground, a sparse scan has few points left, and thick curves through
  // crowns and from wire to wire would explain most of them.
  for (const unsigned seed : {5U, 6U}) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> noise(0, 0.03), crown(0, 1.5);
    Points points;
    for (int tree = 0; tree < 70; ++tree) {
      const Point center(400 * unit(random) - 160, 20 + 60 * unit(random), 4);
      for (int k = 0; k < 45; ++k)
        points.emplace_back(center +
                            Point(crown(random), crown(random), crown(random)));
    }
    const auto wire_at = [](int wire, double x) {
      const double lifted = wire == 1 ? 3 : 0;
      return Point(x, 4.0 * wire, 12 + lifted + 0.0005 * (x - 40) * (x - 40));
    };
    for (int wire = 0; wire < wires; ++wire)
      for (double x = -160; x < 240; x += 2.5 * (0.5 + unit(random)))
        points.emplace_back(wire_at(wire, x) + Point(0, noise(random), noise(random)));
    ASSERT_LT(points.size(), 5000);
    const CurveNetwork network = reconstructCurves(points);
    int near = 0, all = 0;
    for (int wire = 0; wire < wires; ++wire)
      for (double x = -155; x < 235; x += 1, ++all)
        near += distanceTo(network, wire_at(wire, x)) <= 0.15;
    EXPECT_GE(near, 0.8 * all);
    EXPECT_LE(length(network), 1.1 * wires * 400);
  }
}

TEST(MixedReconstruction, ScanLinesOfTheGroundAreNotACloudOfCurves)
{
  // Where scan lines lie farther apart than their points, as below a fast aircraft, the
  // ground is linear around its points, too.
  for (const unsigned seed : {7U, 8U}) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> noise(0, 0.03);
    Points points;
    for (double x = -60; x < 140; x += 1.8)
      for (double y = -30; y < 40; y += 0.2 + 0.1 * unit(random))
        points.emplace_back(x + noise(random), y, std::sin(0.05 * x) + noise(random));
    for (int wire = 0; wire < wires; ++wire)
      for (double x = 0; x < 80; x += 0.6 * unit(random))
        points.emplace_back(wireAt(wire, x) + Point(0, noise(random), noise(random)));
    ASSERT_GT(points.size(), 5000); // otherwise both methods are tried
    const CurveNetwork network = reconstructCurves(points);
    EXPECT_GE(covered(network, Eigen::Affine3d::Identity(), 0.1), 0.97);
    // Of 7,800 m of scan lines, only ends in the corners of the data remain, where the
    // surface fills just a quarter of the neighborhood.
    EXPECT_LE(length(network), 1.1 * wires * 81.5 + 150);
  }
}

TEST(MixedReconstruction, MovesTurnsAndScalesWithTheInput)
{
  Points points = scene(5, true);
  Eigen::Affine3d move = Eigen::Affine3d::Identity();
  move.translate(Point(300, -200, 50));
  move.rotate(Eigen::AngleAxisd(0.7, Point::UnitZ()));
  move.scale(3.2808); // feet
  for (Point& p : points)
    p = move * p;
  EXPECT_GE(covered(reconstructCurves(points), move, 0.33), 0.97);
}

TEST(MixedReconstruction, IsTheSameForAnyNumberOfThreads)
{
  const Points points = scene(6, true);
  ReconstructionSettings settings;
  settings.threads = 1;
  const CurveNetwork one = reconstructCurves(points, settings);
  settings.threads = 3;
  const CurveNetwork three = reconstructCurves(points, settings);
  ASSERT_EQ(one.curves.size(), three.curves.size());
  for (std::size_t c = 0; c < one.curves.size(); ++c)
    EXPECT_EQ(one.curves[c].points, three.curves[c].points);
}

TEST(MixedReconstruction, WiresOfARackAreTrackedOneByOne)
{
  // Hardly farther apart than the points on each: the first curve may drift from wire
  // to wire.
  constexpr int rack = 4;
  const auto at = [](int wire, double x) {
    return Point(x, 0, 8 + 0.34 * wire + 0.001 * (x - 40) * (x - 40));
  };
  for (const unsigned seed : {8U, 9U, 10U}) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> noise(0, 0.025);
    Points points = scene(seed, false);
    for (int wire = 0; wire < rack; ++wire)
      for (int k = 0; k < 180; ++k)
        points.push_back(at(wire, 80 * unit(random)) +
                         Point(0, noise(random), noise(random)));
    const CurveNetwork network = reconstructCurves(points);
    EXPECT_GE(shareNear(network, at, rack, 1, 79, 0.1), 0.95);
    EXPECT_LE(length(network), 1.1 * rack * 82);
  }
}

// As drops from a pole to houses: too short to stand out as clearly as a long wire,
// with points that scatter as far as a seventh of their spacing.
TEST(MixedReconstruction, ShortNoisyCurvesAreCurves)
{
  for (const unsigned seed : {21U, 22U, 23U}) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> noise(0, 0.05);
    Points points = scene(seed, false);
    const auto at = [](int drop, double x) {
      return Point(5 + 9 * drop + 0.3 * x, x - 8, 9 - 0.2 * x + 0.004 * x * x);
    };
    for (int drop = 0; drop < 4; ++drop)
      for (int k = 0; k < 28; ++k)
        points.push_back(at(drop, 10 * unit(random)) +
                         Point(noise(random), noise(random), noise(random)));
    const CurveNetwork network = reconstructCurves(points);
    EXPECT_GE(shareNear(network, at, 4, 0.5, 9.5, 0.1), 0.9);
  }
}

Point
highWireAt(int wire, double x)
{
  return {x, 8.0 * wire - 8, 18 + 20 * std::pow(x / 400 - 1, 2)};
}

/** \brief Three wires over undergrowth \a extent long. */
Points
wiresOverBushes(unsigned seed, double extent)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> noise(0, 0.05);
  Points points;
  for (int bush = 0; bush < extent; ++bush) {
    const Point middle(extent * unit(random), 120 * unit(random) - 60, 2);
    for (int k = 0; k < 6; ++k)
      points.push_back(middle + Point(4 * unit(random) - 2,
                                      4 * unit(random) - 2,
                                      3 * unit(random) - 1.5));
  }
  for (int wire = 0; wire < 3; ++wire)
    for (int k = 0; k < 0.6 * extent; ++k)
      points.push_back(highWireAt(wire, extent * unit(random)) +
                       Point(noise(random), noise(random), noise(random)));
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

/** \brief Length of \a network below 8. */
double
lengthInBushes(const CurveNetwork& network)
{
  double low = 0;
  for (const Curve& curve : network.curves)
    for (std::size_t k = 0; k + 1 < curve.points.size(); ++k)
      if (curve.points[k].z() < 8)
        low += (curve.points[k + 1] - curve.points[k]).norm();
  return low;
}

// Scattered undergrowth lines up here and there, ten times as wide as a wire.
TEST(MixedReconstruction, ThickTracksAreClutterAmongThinCurves)
{
  for (const unsigned seed : {41U, 42U, 43U}) {
    SCOPED_TRACE(seed);
    const CurveNetwork network = reconstructCurves(wiresOverBushes(seed, 800));
    EXPECT_LE(lengthInBushes(network), 0.05 * 3 * 800);
  }
}

// So few points that both methods are tried: the one for clouds of only curves would
// explain all of the undergrowth.
TEST(MixedReconstruction, SmallCloudsOfClutterAndWiresAreScenes)
{
  for (unsigned seed = 44; seed < 56; ++seed) {
    SCOPED_TRACE(seed);
    const CurveNetwork network = reconstructCurves(wiresOverBushes(seed, 200));
    EXPECT_LE(lengthInBushes(network), 0.05 * 3 * 200);
    EXPECT_GE(shareNear(network, highWireAt, 3, 2, 198, 0.15), 0.9);
  }
}

class Stopped : public ProgressMonitor {
public:
  bool
  canceled() const override
  {
    return true;
  }
};

TEST(MixedReconstruction, StopsOnRequest)
{
  Stopped monitor;
  EXPECT_THROW(reconstructCurves(scene(7, true), {}, &monitor), Canceled);
}

TEST(MixedReconstruction, RealWiresOverRealGround)
{
  for (const char* name :
       {"lidar/ahn4_12BZ1_21_thin8.las", "lidar/ahn4_12AN2_20_thin8.las"}) {
    LINELET_NEEDS_DATA(name);
    const io::Cloud cloud = io::readCloud(linelet::test::dataPath(name).string());
    const io::Column* classes = cloud.find("classification");
    ASSERT_NE(classes, nullptr);
    const CurveNetwork network = reconstructCurves(cloud.points);
    int near = 0, all = 0;
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      if (io::valueAt(*classes, i) == 14 && i % 50 == 0) {
        ++all;
        near += distanceTo(network, cloud.points[i]) <= 0.25;
      }
    EXPECT_GE(near, 0.97 * all) << name << ", " << all << " points looked at";
  }
}

} // namespace
