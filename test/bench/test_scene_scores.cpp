// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <bench/measures/scene_scores.h>
#include <bench/scenes/random.h>

namespace {

using namespace linelet;
using namespace linelet::bench;

/** A true wire from x = 0 to x = 100, 10 m up, at a place across. */
SceneWire
trueWire(double y, double bundle_radius = 0, double noise = 0.01)
{
  SceneWire wire;
  wire.bundle_radius = bundle_radius;
  wire.noise = noise;
  wire.points = {Point(0, y, 10), Point(40, y, 10), Point(100, y, 10)};
  return wire;
}

Curve
line(const Point& from, const Point& to)
{
  Curve curve;
  curve.points = {from, to};
  return curve;
}

CurveNetwork
lines(std::vector<Curve> curves)
{
  CurveNetwork network;
  network.curves = std::move(curves);
  return network;
}

/** A vector along all of a wire at y = 0, offset sideways and upward. */
CurveNetwork
beside(double y, double dz = 0)
{
  return lines({line(Point(0, y, 10 + dz), Point(100, y, 10 + dz))});
}

SceneScan
sceneOf(std::vector<SceneWire> wires, std::vector<SceneStructure> structures = {})
{
  SceneScan scan;
  scan.wires = std::move(wires);
  scan.structures = std::move(structures);
  return scan;
}

TEST(SceneScores, APerfectResult)
{
  const SceneScan truth = sceneOf({trueWire(0)});
  for (const SceneScores& s :
       {scoreSceneWires(beside(0), truth), scoreSceneCurves(beside(0), truth)}) {
    EXPECT_NEAR(s.true_length, 100, 1e-9);
    EXPECT_NEAR(s.found_length, 100, 1e-9);
    EXPECT_DOUBLE_EQ(s.recall(), 1);
    EXPECT_DOUBLE_EQ(s.precision(), 1);
    EXPECT_DOUBLE_EQ(s.falseLength(), 0);
  }
}

TEST(SceneScores, EmptyResultAndEmptyTruth)
{
  const SceneScores none = scoreSceneWires({}, sceneOf({trueWire(0)}));
  EXPECT_DOUBLE_EQ(none.recall(), 0);
  EXPECT_TRUE(std::isnan(none.precision()));
  // Without any line, everything found is false, and recall is undefined.
  const SceneScores empty = scoreSceneWires(beside(0), sceneOf({}));
  EXPECT_TRUE(std::isnan(empty.recall()));
  EXPECT_DOUBLE_EQ(empty.precision(), 0);
  EXPECT_NEAR(empty.falseLength(), 100, 1e-9);
  const SceneScores nothing = scoreSceneCurves({}, sceneOf({}));
  EXPECT_EQ(nothing.true_length, 0);
  EXPECT_EQ(nothing.found_length, 0);
}

/** The three tolerances of a wire: 10 cm, three times its noise, its bundle plus 10
 * cm. */
TEST(SceneScores, Tolerances)
{
  const auto wires = [](double off, const SceneWire& wire) {
    return scoreSceneWires(beside(off), sceneOf({wire})).recall();
  };
  EXPECT_EQ(wires(0.099, trueWire(0)), 1);
  EXPECT_EQ(wires(0.101, trueWire(0)), 0);
  EXPECT_EQ(wires(0.299, trueWire(0, 0, 0.1)), 1);
  EXPECT_EQ(wires(0.301, trueWire(0, 0, 0.1)), 0);
  EXPECT_EQ(wires(0.419, trueWire(0, 0.32, 0.1)), 1);
  EXPECT_EQ(wires(0.421, trueWire(0, 0.32, 0.1)), 0);
  // Curves have no allowance for noise.
  const auto curves = [](double off, const SceneWire& wire) {
    return scoreSceneCurves(beside(off), sceneOf({wire})).recall();
  };
  EXPECT_EQ(curves(0.101, trueWire(0, 0, 0.1)), 0);
  EXPECT_EQ(curves(0.419, trueWire(0, 0.32, 0.1)), 1);
  EXPECT_EQ(curves(0.421, trueWire(0, 0.32, 0.1)), 0);
}

/** Each wire has its own tolerance, even next to another. */
TEST(SceneScores, EachWireByItself)
{
  // The vector lies 0.3 m from both: within the bundle's tolerance, not the wire's.
  const SceneScan truth = sceneOf({trueWire(0), trueWire(0.6, 0.25)});
  const SceneScores s = scoreSceneWires(beside(0.3), truth);
  EXPECT_NEAR(s.true_length, 200, 1e-9);
  EXPECT_NEAR(s.covered_length, 100, 1e-9);
  EXPECT_DOUBLE_EQ(s.precision(), 1);
}

TEST(SceneScores, PartsCountByTheirLength)
{
  const CurveNetwork found = lines({line(Point(60, 0, 10), Point(130, 0, 10)),
                                    line(Point(0, 5, 10), Point(0, 35, 10))});
  const SceneScores s = scoreSceneWires(found, sceneOf({trueWire(0)}));
  EXPECT_NEAR(s.covered_length, 40, 0.51);
  EXPECT_NEAR(s.found_length, 100, 1e-9);
  EXPECT_NEAR(s.falseLength(), 30 - 0.5 + 30, 0.51); // half a meter is tolerated
}

/** A vector twice over the same wire covers it once. */
TEST(SceneScores, CoverIsNotASum)
{
  CurveNetwork twice = beside(0);
  twice.curves.push_back(twice.curves.front());
  const SceneScores s = scoreSceneWires(twice, sceneOf({trueWire(0)}));
  EXPECT_NEAR(s.covered_length, 100, 1e-9);
  EXPECT_NEAR(s.found_length, 200, 1e-9);
}

/** Not every curve is a wire; a jumper loop counts as both. */
TEST(SceneScores, OtherLongThinThings)
{
  const Point from(0, 20, 5), to(100, 20, 5);
  const CurveNetwork found = lines({line(from, to)});
  for (const StructureKind kind : {StructureKind::Pipe,
                                   StructureKind::Guy,
                                   StructureKind::Fence,
                                   StructureKind::Branch,
                                   StructureKind::Pole}) {
    const SceneScan truth = sceneOf({trueWire(0)}, {{kind, from, to, 0.05}});
    EXPECT_DOUBLE_EQ(scoreSceneWires(found, truth).precision(), 0);
    EXPECT_DOUBLE_EQ(scoreSceneCurves(found, truth).precision(), 1);
    EXPECT_DOUBLE_EQ(scoreSceneWires(found, truth).true_length, 100);
  }
  const SceneScan jumper = sceneOf({}, {{StructureKind::Jumper, from, to, 0.01}});
  EXPECT_DOUBLE_EQ(scoreSceneWires(found, jumper).precision(), 1);
}

/** A pipe is matched on its surface, a thin thing near its axis, each by its own
 * size. */
TEST(SceneScores, ThicknessOfThings)
{
  const Point axis_from(0, 0, 5), axis_to(100, 0, 5);
  const auto precision = [&](double radius, double off) {
    const SceneScan truth =
        sceneOf({},
                {{StructureKind::Pipe, axis_from, axis_to, radius},
                 {StructureKind::Guy, Point(0, 2, 5), Point(100, 2, 5), 0.01}});
    const CurveNetwork found =
        lines({line(Point(0, 0, 5 + off), Point(100, 0, 5 + off))});
    return scoreSceneCurves(found, truth).precision();
  };
  EXPECT_EQ(precision(0.3, 0.54), 1);
  EXPECT_EQ(precision(0.3, 0.56), 0);
  EXPECT_EQ(precision(0.02, 0.26), 1);
  EXPECT_EQ(precision(0.02, 0.28), 0);
}

TEST(SceneScores, ClosedCurvesKeepTheirLastEdge)
{
  Curve square;
  square.points = {Point(0, 0, 0), Point(10, 0, 0), Point(10, 10, 0), Point(0, 10, 0)};
  square.closed = true;
  EXPECT_NEAR(scoreSceneCurves(lines({square}), sceneOf({})).found_length, 40, 1e-9);
}

TEST(SceneScores, CurvesWithoutLength)
{
  Curve none, one;
  one.points = {Point(0.25, 0, 10)};
  const SceneScores s = scoreSceneWires(lines({none, one}), sceneOf({trueWire(0)}));
  EXPECT_EQ(s.found_length, 0);
  EXPECT_EQ(s.covered_length, 0.5); // the sample where the vertex lies
}

/** Scores do not change when truth and result are turned and moved together. */
TEST(SceneScores, Invariance)
{
  Random random(11);
  SceneScan truth =
      sceneOf({trueWire(0), trueWire(3, 0.3, 0.05), trueWire(7, 0, 0.1)},
              {{StructureKind::Pipe, Point(0, 12, 6), Point(90, 15, 6), 0.2}});
  CurveNetwork found;
  for (int i = 0; i < 30; ++i) {
    Point from, to;
    for (Point* p : {&from, &to}) {
      p->x() = random.uniform(0, 100);
      p->y() = random.integer(0, 3) * 3.5 + random.normal(0.15);
      p->z() = 10 + random.normal(0.15);
    }
    to.y() = from.y() + random.normal(0.1);
    found.curves.push_back(line(from, to));
  }
  SceneScoreSettings settings;
  settings.step = 0.37; // no length is a multiple: rounding adds no sample
  const SceneScores wires = scoreSceneWires(found, truth, settings);
  const SceneScores curves = scoreSceneCurves(found, truth, settings);
  ASSERT_GT(wires.covered_length, 10);
  ASSERT_GT(wires.falseLength(), 10);
  const Eigen::Isometry3d motion =
      Eigen::Translation3d(4000, -2500, 310) *
      Eigen::AngleAxisd(1.1, Point(0.2, -0.1, 1).normalized());
  const auto move = [&](Points& points) {
    for (Point& p : points)
      p = motion * p;
  };
  for (SceneWire& wire : truth.wires)
    move(wire.points);
  for (SceneStructure& s : truth.structures) {
    s.from = motion * s.from;
    s.to = motion * s.to;
  }
  for (Curve& curve : found.curves)
    move(curve.points);
  const SceneScores moved_wires = scoreSceneWires(found, truth, settings);
  const SceneScores moved_curves = scoreSceneCurves(found, truth, settings);
  EXPECT_NEAR(moved_wires.covered_length, wires.covered_length, 1e-6);
  EXPECT_NEAR(moved_wires.right_length, wires.right_length, 1e-6);
  EXPECT_NEAR(moved_wires.found_length, wires.found_length, 1e-6);
  EXPECT_NEAR(moved_curves.covered_length, curves.covered_length, 1e-6);
  EXPECT_NEAR(moved_curves.right_length, curves.right_length, 1e-6);
}

/** The truth itself scores perfectly in every scene. */
TEST(SceneScores, TheTruthOfAScene)
{
  SceneSettings settings;
  settings.kind = SceneKind::Street;
  settings.density = 1;
  const SceneScan scan = simulateScene(settings);
  CurveNetwork found;
  for (const SceneWire& wire : scan.wires) {
    Curve curve;
    curve.points = wire.points;
    found.curves.push_back(curve);
  }
  const SceneScores s = scoreSceneWires(found, scan);
  EXPECT_GT(s.true_length, 500);
  EXPECT_DOUBLE_EQ(s.recall(), 1);
  EXPECT_DOUBLE_EQ(s.precision(), 1);
  EXPECT_DOUBLE_EQ(scoreSceneCurves(found, scan).precision(), 1);
}

TEST(SceneScores, Sums)
{
  SceneScores sum = scoreSceneWires(beside(0), sceneOf({trueWire(0)}));
  sum += scoreSceneWires(beside(9), sceneOf({trueWire(0)}));
  EXPECT_DOUBLE_EQ(sum.recall(), 0.5);
  EXPECT_DOUBLE_EQ(sum.precision(), 0.5);
}

std::vector<CalibrationBin>
halves()
{
  std::vector<CalibrationBin> bins(2);
  bins[0].to = bins[1].from = 0.5;
  return bins;
}

TEST(Calibration, WiresByStatedConfidence)
{
  const SceneScan truth = sceneOf({trueWire(0)});
  const Curve right = beside(0).curves[0], wrong = beside(8).curves[0];
  std::vector<CalibrationBin> bins = halves();
  // 0.5 falls into the upper bin, and 1 into the last one.
  calibrate(lines({right, wrong, right, wrong}), {1, 0.5, 0.75, 0.25}, truth, bins);
  EXPECT_EQ(bins[0].wires, 1U);
  EXPECT_EQ(bins[0].right, 0U);
  EXPECT_DOUBLE_EQ(bins[0].confidence_sum, 0.25);
  EXPECT_EQ(bins[1].wires, 3U);
  EXPECT_EQ(bins[1].right, 2U);
  EXPECT_DOUBLE_EQ(bins[1].confidence_sum, 2.25);
  // A second call adds to the bins.
  calibrate(lines({wrong}), {0.1}, truth, bins);
  EXPECT_EQ(bins[0].wires, 2U);
}

TEST(Calibration, HalfAWireDecides)
{
  const SceneScan truth = sceneOf({trueWire(0)});
  std::vector<CalibrationBin> bins = halves();
  calibrate(lines({line(Point(40, 0, 10), Point(155, 0, 10)),
                   line(Point(40, 0, 10), Point(165, 0, 10))}),
            {0.9, 0.9},
            truth,
            bins);
  EXPECT_EQ(bins[1].wires, 2U);
  EXPECT_EQ(bins[1].right, 1U);
}

TEST(Calibration, OneConfidenceAWire)
{
  std::vector<CalibrationBin> bins = halves();
  EXPECT_THROW(calibrate(beside(0), {}, sceneOf({}), bins), std::invalid_argument);
}

} // namespace
