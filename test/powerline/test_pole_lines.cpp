// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Pole lines along streets: racks whose wires are closer together than their kinks are
// deep, and roofs beside them.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <bench/measures/scene_scores.h>
#include <bench/scenes/scene.h>
#include <linelet/powerline/extract_power_lines.h>

#include "powerline/fittings/curve_through.h"
#include "powerline/pieces/chords.h"
#include "powerline/pieces/tangents.h"
#include "powerline/scene_builder.h"
#include "powerline/terrain/find_ground.h"

namespace linelet::powerline {
namespace {

constexpr double a = 450; // catenary parameter, meters

/** Slopes along spans of 40 m between level supports, two samples per meter. */
std::vector<Tangents::Sample>
slopes(double from, double to, test::SceneBuilder& random)
{
  std::vector<Tangents::Sample> samples;
  for (double s = from; s < to; s += 0.5) {
    const double on = s - 40 * std::floor(s / 40) - 20; // from the middle of a span
    samples.push_back({s, std::sinh(on / a) + random.normal(0.006)});
  }
  return samples;
}

TEST(FindKinks, IsWhereSlopesBreakDownwards)
{
  for (const std::uint32_t seed : {1, 2, 3, 4, 5}) {
    test::SceneBuilder random(seed);
    const std::vector<double> kinks = findKinks(slopes(5, 150, random));
    ASSERT_EQ(kinks.size(), 3U) << "seed " << seed;
    for (std::size_t k = 0; k < kinks.size(); ++k)
      EXPECT_NEAR(kinks[k], 40. * static_cast<double>(k + 1), 3) << "seed " << seed;
    EXPECT_TRUE(findKinks(slopes(1, 39, random)).empty()) << "seed " << seed;
  }
}

TEST(FindKinks, IsNotWhereStripsDoNotFit)
{
  // One strip ends and the next lies .1 m lower: neighborhoods of 4 m dip across that
  // step, and the slope lags by as much as the bend contributes in a few meters.
  for (const std::uint32_t seed : {1, 2, 3}) {
    test::SceneBuilder random(seed);
    std::vector<Tangents::Sample> samples;
    for (double s = -60; s < 60; s += 0.5) {
      const double dip = std::abs(s) < 4 ? 0.03 * (1 - std::abs(s) / 4) : 0;
      samples.push_back({s, s / a - dip + random.normal(0.003)});
    }
    EXPECT_TRUE(findKinks(samples).empty()) << "seed " << seed;
  }
  EXPECT_TRUE(findKinks(std::vector<Tangents::Sample>{}).empty());
}

bench::SceneScores
scoresOf(bench::SceneKind kind, std::uint32_t seed)
{
  bench::SceneSettings settings;
  settings.kind = kind;
  settings.seed = seed;
  const bench::SceneScan scan = simulateScene(settings);
  CurveNetwork found;
  for (const Wire& wire : extractPowerLines(scan.points).wires) {
    Curve curve;
    curve.points = polyline(wire);
    found.curves.push_back(std::move(curve));
  }
  return scoreSceneWires(found, scan);
}

// Four wires .35 m apart with one point per meter: .815 before directions revealed the
// poles.
TEST(Rack, IsFollowedFromPoleToPole)
{
  EXPECT_GT(scoresOf(bench::SceneKind::Town, 7).recall(), 0.86);
}

// Where wires sag as much as they are apart, straight lines lead from the middle of one
// to the ends of the next: they took the points of both and were then rejected as too
// straight.
TEST(Rack, HasNoStraightWires)
{
  constexpr double span = 40, apart = 0.35;
  constexpr double catenary = span * span / (8 * apart);
  double found = 0, all = 0;
  for (const std::uint32_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    test::SceneBuilder scene(seed);
    scene.ground(-10, -15, 5 * span + 10, 15, 6);
    std::vector<Curve> truth;
    for (int k = 0; k < 5; ++k)
      for (int w = 0; w < 4; ++w) {
        const Point from(k * span, 0, 9 + w * apart), to(from.x() + span, 0, from.z());
        scene.wire(from, to, catenary, 1.5, 0.05);
      }
    for (int k = 0; k <= 5; ++k)
      scene.box({k * span - 0.1, -0.1, 0}, {k * span + 0.1, 0.1, 10.3}, 60);
    const PowerLineNetwork network = extractPowerLines(scene.points);
    for (double x = 3; x < 5 * span - 3; x += 0.5) {
      const double on = x - span * std::floor(x / span) - span / 2;
      for (int w = 0; w < 4; ++w) {
        const Point p(
            x, 0, 9 + w * apart - apart + catenary * (std::cosh(on / catenary) - 1));
        all += 1;
        found += std::any_of(
            network.wires.begin(), network.wires.end(), [&](const Wire& wire) {
              return distanceTo(polyline(wire), p) <= 0.15;
            });
      }
    }
  }
  EXPECT_GT(found / all, 0.9);
}

TEST(Chords, OfARackGoAndThoseAloneStay)
{
  constexpr double span = 40, apart = 0.35;
  constexpr double catenary = span * span / (8 * apart);
  test::SceneBuilder scene(3);
  scene.ground(-10, -15, 2 * span + 10, 15, 6);
  for (int k = 0; k < 2; ++k)
    for (int w = 0; w < 2; ++w)
      scene.wire({k * span, 0, 9 + w * apart},
                 {(k + 1) * span, 0, 9 + w * apart},
                 catenary,
                 4,
                 0.03);
  const Candidates candidates =
      findCandidates(scene.points, findGround(scene.points, {}, false), 3);
  const auto pieceOf = [&](double from, double to, double cut, const auto& height) {
    Piece piece;
    for (std::size_t i = 0; i < candidates.points.size(); ++i) {
      const Point& p = candidates.points[i];
      if (p.x() > from && p.x() < to && std::abs(p.z() - height(p.x())) < cut)
        piece.members.push_back(static_cast<Index>(i));
    }
    piece.model.direction = Eigen::Vector2d::UnitX();
    EXPECT_TRUE(fit(piece.model,
                    candidates.points,
                    piece.members,
                    std::numeric_limits<double>::infinity()));
    updateExtent(piece, candidates.points);
    return piece;
  };
  const Piece wire = pieceOf(0, span, 0.15, [&](double x) {
    return 9 - apart + catenary * (std::cosh((x - span / 2) / catenary) - 1);
  });
  const Piece chord = pieceOf(0, 2 * span, 0.1, [](double) { return 9; });
  Growth growth(candidates, {});
  std::vector<Piece> pieces = {chord, wire};
  dropChords(growth, pieces);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces.front().members, wire.members);
  pieces = {chord};
  dropChords(growth, pieces);
  EXPECT_EQ(pieces.size(), 1U);
}

// 276 m of rows on roofs at the border of the data, which the line beside them used to
// support as evidence.
TEST(Roofs, BesideALineAreNotWires)
{
  EXPECT_LT(scoresOf(bench::SceneKind::Town, 8).falseLength(), 15);
}

// Five parallel pipes cut off by the border of the data, 118 m in total.
TEST(Pipes, AtTheBorderAreNotWires)
{
  EXPECT_LT(scoresOf(bench::SceneKind::ClutterEmpty, 6).falseLength(), 15);
}

} // namespace
} // namespace linelet::powerline
