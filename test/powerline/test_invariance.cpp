// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Position, heading, point order and unit of a scan do not change its wires; with fewer
// points, fewer are found, but no false ones.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <bench/measures/scene_scores.h>
#include <bench/scenes/scene.h>
#include <linelet/powerline/extract_power_lines.h>

namespace linelet::powerline {
namespace {

using bench::SceneKind;
using bench::SceneScan;
using bench::SceneScores;

constexpr std::uint32_t seed = 2;

CurveNetwork
wiresOf(const PowerLineNetwork& network)
{
  CurveNetwork wires;
  for (const Wire& wire : network.wires) {
    wires.curves.emplace_back();
    wires.curves.back().points = polyline(wire);
  }
  return wires;
}

/** \a wires as a truth to compare others with. */
SceneScan
asTruth(const CurveNetwork& wires)
{
  SceneScan truth;
  for (const Curve& curve : wires.curves) {
    truth.wires.emplace_back();
    truth.wires.back().points = curve.points;
  }
  return truth;
}

/** How much may change. */
struct Bounds {
  double recall;     ///< share of the true wires lost
  double kept, same; ///< of the wires of the scan as it is: within 5 cm of those of the
                     ///< changed one, and the other way round
  double invented;   ///< meters
};

/** Standard, seeds 1 to 3, all changes: recall changes by at most .0003, .9997 are
 * kept, .9999 the same. Street, seeds 1 to 4, six changes each, is not invariant:
 * recall changes by -.032 to +.007, .868 to 1 are kept, .868 to 1 the same. A voxel's
 * seed being its first point is not the only reason: with the point nearest to the mean
 * it is no better. */
Bounds
sameLines(SceneKind kind)
{
  if (kind == SceneKind::Street)
    return {0.04, 0.85, 0.85, 3};
  return {0.001, 0.999, 0.999, 0.5};
}

/** Two drawings for each of seeds 1 to 3: one point in two loses up to .003 of recall,
 * one in four up to .0099. */
Bounds
fewerPoints(unsigned one_in)
{
  return one_in == 2 ? Bounds{0.004, 0.997, 0.999, 0.5}
                     : Bounds{0.012, 0.983, 0.993, 0.5};
}

/** A scan, its truth and the wires found in the original. */
struct Found {
  SceneScan scan;
  CurveNetwork wires;
  SceneScores scores;

  explicit Found(SceneKind kind)
  {
    bench::SceneSettings settings;
    settings.kind = kind;
    settings.seed = seed;
    scan = simulateScene(settings);
    wires = wiresOf(extractPowerLines(scan.points));
    scores = scoreSceneWires(wires, scan);
  }
};

/** Computed once for all tests of a process. */
const Found&
foundIn(SceneKind kind)
{
  static std::map<SceneKind, Found> all;
  return all.try_emplace(kind, kind).first->second;
}

class Invariance : public testing::TestWithParam<SceneKind> {
protected:
  const SceneScan& scan_ = foundIn(GetParam()).scan;
  const CurveNetwork& wires_ = foundIn(GetParam()).wires;
  const SceneScores& scores_ = foundIn(GetParam()).scores;

  /** Wires of the scan with every point moved by \a there, then moved back. */
  CurveNetwork
  found(const std::function<Point(const Point&)>& there,
        const std::function<Point(const Point&)>& back) const
  {
    Points points = scan_.points;
    std::transform(points.begin(), points.end(), points.begin(), there);
    CurveNetwork wires = wiresOf(extractPowerLines(points));
    for (Curve& curve : wires.curves)
      std::transform(
          curve.points.begin(), curve.points.end(), curve.points.begin(), back);
    return wires;
  }

  void
  expectSame(const CurveNetwork& wires, const Bounds& allowed) const
  {
    const SceneScores truth = scoreSceneWires(wires, scan_);
    EXPECT_GE(truth.recall(), scores_.recall() - allowed.recall);
    EXPECT_LE(truth.falseLength(), scores_.falseLength() + allowed.invented);
    bench::SceneScoreSettings near;
    near.near = near.margin = near.astray = 0.05;
    const SceneScores each = scoreSceneWires(wires, asTruth(wires_), near);
    EXPECT_GE(each.recall(), allowed.kept);
    EXPECT_GE(each.precision(), allowed.same);
  }
};

TEST_P(Invariance, ThereAreWiresToCompare)
{
  EXPECT_GT(scores_.true_length, 500);
  EXPECT_GT(scores_.recall(), 0.8);
}

TEST_P(Invariance, OfThePlaceOfTheScan)
{
  // The second is what a reader that forgets its shift passes on (UTM).
  for (const Point& d :
       {Point(123.4567, -2345.678, 57.31), Point(402123.37, 5654321.13, 312.7)}) {
    SCOPED_TRACE(testing::Message() << "moved by " << d.transpose());
    expectSame(found([&](const Point& p) { return Point(p + d); },
                     [&](const Point& p) { return Point(p - d); }),
               sameLines(GetParam()));
  }
}

TEST_P(Invariance, OfTheHeadingOfTheScan)
{
  for (const double degrees : {17.0, 137.0}) {
    SCOPED_TRACE(testing::Message() << "turned by " << degrees << " degrees");
    const double angle = degrees / 180 * std::acos(-1.0);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(angle, Point::UnitZ()).toRotationMatrix();
    expectSame(found([&](const Point& p) { return Point(turn * p); },
                     [&](const Point& p) { return Point(turn.transpose() * p); }),
               sameLines(GetParam()));
  }
}

TEST_P(Invariance, OfTheOrderOfThePoints)
{
  Points points = scan_.points;
  std::mt19937 random(seed);
  std::shuffle(points.begin(), points.end(), random);
  expectSame(wiresOf(extractPowerLines(points)), sameLines(GetParam()));
}

TEST_P(Invariance, OfTheUnit)
{
  constexpr double foot = 1200.0 / 3937; // of the United States survey, meters
  io::Cloud cloud;
  cloud.points = scan_.points;
  for (Point& p : cloud.points)
    p /= foot;
  cloud.wkt = R"(LOCAL_CS["county",UNIT["US survey foot",0.3048006096012192]])";
  expectSame(wiresOf(extractPowerLines(cloud)), sameLines(GetParam()));
}

TEST_P(Invariance, FewerPointsLoseLittleAndInventNothing)
{
  if (GetParam() != SceneKind::Standard)
    GTEST_SKIP()
        << "not reached on streets, seeds 1 to 4: one point in two loses up to .082 of "
           "the recall and invents up to 35 m, one in four loses .16 to .32";
  for (const unsigned one_in : {2u, 4u}) {
    SCOPED_TRACE(testing::Message() << "one point in " << one_in);
    std::mt19937 random(seed);
    Points points;
    for (const Point& p : scan_.points)
      if (random() % one_in == 0)
        points.push_back(p);
    expectSame(wiresOf(extractPowerLines(points)), fewerPoints(one_in));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes,
                         Invariance,
                         testing::Values(SceneKind::Standard, SceneKind::Street),
                         [](const auto& scene) {
                           return std::string(nameOf(scene.param));
                         });

} // namespace
} // namespace linelet::powerline
