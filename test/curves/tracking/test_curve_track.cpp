// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Curves followed through clutter, compared with the planted line.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "curves/tracking/curve_track.h"
#include "curves/tracking/lines_of_track.h"
#include "curves/tracking/track_fit.h"

using namespace linelet;

namespace {

/** \brief A parabola of length 60 with 2 points per unit, and scattered points around
 * it. */
Points
lineInClutter(double clutter, unsigned seed, bool line = true)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 0.03);
  std::uniform_real_distribution<double> along(0, 60), across(-4, 4);
  Points points;
  for (int k = 0; line && k < 120; ++k) {
    const double x = along(random);
    points.emplace_back(x, noise(random), 0.001 * x * x + noise(random));
  }
  const int count = static_cast<int>(clutter * 60 * 8 * 8);
  for (int k = 0; k < count; ++k)
    points.emplace_back(along(random), across(random), across(random));
  return points;
}

TrackSeed
seedAt(const Point& at)
{
  TrackSeed seed;
  seed.at = at;
  seed.direction = Point(1, 0.01, 0.05).normalized();
  seed.radius = 3;
  seed.density = 2;
  seed.noise = 0.1;
  return seed;
}

TEST(CurveTrack, FollowsALineThroughClutterToBothEnds)
{
  for (const unsigned seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    const Points points = lineInClutter(0.5, seed);
    const TrackedScene scene(points, 0.5);
    const Track track = followCurve(scene, seedAt({30, 0, 0.9}), {0.01, 10}, 12);
    ASSERT_GT(track.members.size(), 80U);
    EXPECT_GT(track.evidence, 100);
    EXPECT_LT(std::min(track.path.front().x(), track.path.back().x()), 3);
    EXPECT_GT(std::max(track.path.front().x(), track.path.back().x()), 57);
    EXPECT_NEAR(track.noise, 0.03, 0.015);
    EXPECT_NEAR(track.density, 2, 0.8);
    for (const Point& p : track.path)
      EXPECT_LT(std::hypot(p.y(), p.z() - 0.001 * p.x() * p.x()), 0.12);
  }
}

TEST(CurveTrack, HardlyEverSeesAThinCurveInClutterAlone)
{
  // The box of clutter is itself a thick curve: only thin ones count.
  int starts = 0, seen = 0;
  for (unsigned seed = 20; seed < 30; ++seed) {
    const Points points = lineInClutter(0.5, seed, false);
    const TrackedScene scene(points, 0.5);
    for (double x = 5; x < 60; x += 5, ++starts) {
      const Track track = followCurve(scene, seedAt({x, 0, 0}), {0.01, 10}, 12);
      seen += track.noise * track.density < 0.25 &&
              track.evidence > 20 + std::log(points.size());
    }
  }
  EXPECT_LE(seen, starts / 20) << "of " << starts;
}

// Of a quarter of the points, half of the tracks lose the line, and must end then
// rather than go astray in the clutter.
TEST(CurveTrack, HardlyGoesAstrayWhereLittleOfTheLineIsSeen)
{
  constexpr unsigned runs = 200;
  unsigned astray = 0, far = 0;
  for (unsigned seed = 1; seed <= runs; ++seed) {
    Points points = lineInClutter(1, seed);
    std::size_t line = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
      if (k >= 120 || points[k].x() < 20 || k % 4 == 0)
        points[line++] = points[k];
    points.resize(line);
    const TrackedScene scene(points, 0.5);
    const Track track = followCurve(scene, seedAt({10, 0, 0.1}), {0.01, 10}, 12);
    ASSERT_FALSE(track.path.empty());
    const Point a = track.path.front(), b = track.path.back();
    const Point end = a.x() > b.x() ? a : b;
    far += end.x() > 30;
    astray += std::hypot(end.y(), end.z() - 0.001 * end.x() * end.x()) > 0.25;
  }
  EXPECT_LE(astray, runs / 20);
  EXPECT_GE(far, runs / 2);
}

// A crown of 30 m over a wire of 4 points per meter, an eighth of which it shows: only
// a curve that bends as evenly as the wire is found again behind it.
TEST(CurveTrack, FollowsAnEvenCurveThroughACrown)
{
  constexpr unsigned runs = 50;
  unsigned behind = 0, astray = 0;
  for (unsigned seed = 1; seed <= runs; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> noise(0, 0.03);
    const auto height = [](double x) { return 0.001 * (x - 50) * (x - 50); };
    Points points;
    for (int k = 0; k < 400; ++k) {
      const double x = 100 * unit(random);
      if (x < 35 || x > 65 || unit(random) < 0.125)
        points.emplace_back(x, noise(random), height(x) + noise(random));
    }
    for (int k = 0; k < 1500; ++k)
      points.emplace_back(
          35 + 30 * unit(random), 6 * unit(random) - 3, 6 * unit(random) - 3);
    const TrackedScene scene(points, 0.5);
    const Track track = followCurve(scene, seedAt({10, 0, 1.6}), {0.01, 10}, 12);
    ASSERT_FALSE(track.path.empty());
    const Point a = track.path.front(), b = track.path.back();
    const Point end = a.x() > b.x() ? a : b;
    behind += end.x() > 90;
    astray += std::hypot(end.y(), end.z() - height(end.x())) > 0.25;
  }
  EXPECT_GE(behind, 3 * runs / 4);
  EXPECT_LE(astray, runs / 20);
}

TEST(CurveTrack, CrossesAHiddenStretch)
{
  Points points = lineInClutter(0.2, 8);
  points.erase(std::remove_if(points.begin(),
                              points.end(),
                              [](const Point& p) { return p.x() > 25 && p.x() < 31; }),
               points.end());
  const TrackedScene scene(points, 0.5);
  const Track track = followCurve(scene, seedAt({15, 0, 0.2}), {0.01, 10}, 12);
  ASSERT_FALSE(track.path.empty());
  EXPECT_GT(std::max(track.path.front().x(), track.path.back().x()), 55);
}

TEST(CurveTrack, LeavesThePointsOfOtherCurves)
{
  const Points points = lineInClutter(0.2, 9);
  TrackedScene scene(points, 0.5);
  for (std::size_t i = 0; i < points.size(); ++i)
    scene.taken[i] = scene.grid.inputIndices()[i] < 120;
  EXPECT_LT(followCurve(scene, seedAt({30, 0, 0.9}), {0.01, 10}, 12).evidence, 20);
}

TEST(TrackFit, ASparseNoisyWireIsKnownBetterThanItsPoints)
{
  // 270 long, a point every 3, noise of 0.15: following the points exactly is as wrong
  // as they are, while a parabola through all of them is off by some 0.03.
  double squares = 0, count = 0;
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 0.15);
    std::uniform_real_distribution<double> along(0, 270);
    const auto height = [](double x) { return 5e-4 * (x - 135) * (x - 135); };
    Points points;
    for (int k = 0; k < 90; ++k) {
      const double x = along(random);
      points.emplace_back(x, noise(random), height(x) + noise(random));
    }
    const TrackedScene scene(points, 5);
    TrackSeed start;
    start.at = {135, 0, 0};
    start.radius = 20;
    start.density = 0.33;
    start.noise = 0.15;
    start.direction = Point::UnitX();
    const Track track = followCurve(scene, start, {0.01, 10}, 12);
    ASSERT_GT(track.members.size(), 60U) << seed;
    const TrackFit fit =
        TrackFitter(scene, track, false, 1, [] { return false; }).toSurroundings();
    ASSERT_EQ(fit.fit.curves.size(), 1U) << seed;
    for (const Point& p : fit.fit.curves.front().nodes) {
      squares += p.y() * p.y() + std::pow(p.z() - height(p.x()), 2);
      count += 2;
    }
  }
  EXPECT_LT(std::sqrt(squares / count), 0.07);
}

TEST(LinesAlong, TellsFourLinesFromOneThickOne)
{
  std::mt19937 random(10);
  std::normal_distribution<double> noise(0, 0.02);
  std::uniform_real_distribution<double> along(0, 50);
  const Point offsets[] = {{0, -.2, -.2}, {0, .2, -.2}, {0, -.2, .2}, {0, .2, .2}};
  Points points;
  for (const Point& offset : offsets)
    for (int k = 0; k < 60; ++k)
      points.emplace_back(Point(along(random), noise(random), noise(random)) + offset);
  ModelCurve middle;
  for (int k = 0; k <= 50; ++k)
    middle.nodes.emplace_back(k, 0, 0);
  bool found = false;
  for (const ParallelLines& lines : linesAlong(middle, points, 0.2, 0.01)) {
    if (lines.curves.size() != 4)
      continue;
    found = true;
    for (const Point& offset : offsets) {
      double nearest = 1;
      for (const ModelCurve& line : lines.curves)
        nearest = std::min(nearest,
                           (line.nodes.front() - middle.nodes.front() - offset).norm());
      EXPECT_LT(nearest, 0.03);
    }
  }
  EXPECT_TRUE(found);
}

} // namespace
