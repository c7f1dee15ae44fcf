// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <gtest/gtest.h>

#include "powerline/pieces/evidence.h"
#include "powerline/pieces/find_pieces.h"
#include "powerline/pieces/kinks.h"
#include "powerline/scene_builder.h"
#include "powerline/spans/joints.h"
#include "powerline/terrain/find_ground.h"

namespace linelet::powerline {
namespace {

using test::SceneBuilder;

Indices
everyIndex(const Points& points)
{
  Indices all(points.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = static_cast<Index>(i);
  return all;
}

/** Wires grown in a scene, before bundles and supports are resolved. */
std::vector<Piece>
grown(const Points& points, const PowerLineSettings& settings = {})
{
  const Ground ground = findGround(points, {}, false);
  const Candidates candidates = findCandidates(points, ground, settings.min_height);
  const std::vector<Seed> seeds = findSeeds(candidates, 1, nullptr);
  Growth growth(candidates, settings, seeds);
  return growAll(growth, seeds, settings, nullptr);
}

TEST(SpanModel, KeepsItsCurveWhenReframed)
{
  SpanModel m;
  m.origin = {10, -4};
  m.direction = Eigen::Vector2d(3, 1).normalized();
  m.t = {0.2, 0.03, 1e-5};
  m.z = {20, -0.05, 4e-4};
  m.begin = -40;
  m.end = 110;
  const SpanModel turned = m.reframed();
  EXPECT_NEAR(turned.t[1], 0, 1e-12);
  for (double s = m.begin; s <= m.end; s += 15)
    EXPECT_LT(turned.distance(m.at(s)), 0.01);
}

TEST(Fit, SurvivesAThirdOfOutliers)
{
  SceneBuilder scene(31);
  const Point from(0, 0, 20), to(120, 40, 25);
  scene.wire(from, to, 1200, 3, 0.03);
  scene.box({20, 5, 14}, {90, 30, 30}, 150);
  SpanModel m;
  m.direction = (to - from).head<2>().normalized();
  m.z = {19, 0.0, 0};
  m.z[1] = 5.0 / std::hypot(120, 40);
  ASSERT_TRUE(fit(m, scene.points, everyIndex(scene.points), 3));
  ASSERT_TRUE(fit(m, scene.points, everyIndex(scene.points), 0.6));
  ASSERT_TRUE(fit(m, scene.points, everyIndex(scene.points)));
  for (double s = 0; s < 126; s += 6)
    EXPECT_LT(m.distance(SceneBuilder::onWire(from, to, 1200, s)), 0.05);
  EXPECT_FALSE(fit(m, scene.points, {0, 1}));
}

TEST(Collect, FindsTheMiddleOfABundleFromOneOfItsConductors)
{
  // Two level conductors 0.4 m apart, seen with footprints of 0.28 m.
  SceneBuilder scene(35);
  scene.ground(-5, -10, 105, 10, 4);
  for (const double y : {-0.2, 0.2})
    scene.box({0, y - 0.14, 19.97}, {100, y + 0.14, 20.03}, 800);
  const Ground ground = findGround(scene.points, {}, false);
  const PowerLineSettings settings;
  const Candidates candidates =
      findCandidates(scene.points, ground, settings.min_height);
  const Growth growth(candidates, settings);
  Piece piece;
  piece.thickness = 0.5;
  piece.model.t = {-0.2, 0, 0};
  piece.model.z = {20, 0, 0};
  piece.model.begin = 0;
  piece.model.end = 100;
  for (int round = 0; round < 2; ++round)
    ASSERT_TRUE(growth.collect(piece, piece.thickness));
  for (double s = 0; s <= 100; s += 10)
    EXPECT_NEAR(piece.model.at(s).y(), 0, 0.05) << "at " << s;
}

TEST(FindKinks, SeesASupportAndNoSag)
{
  SceneBuilder scene(33);
  scene.wire({0, 0, 9}, {40, 0, 9}, 400, 3, 0.03);
  scene.wire({40, 0, 9}, {85, 0, 9.5}, 400, 3, 0.03);
  Piece piece;
  piece.members = everyIndex(scene.points);
  piece.model.end = 85;
  piece.model.z[0] = 9;
  const std::vector<double> kinks = findKinks(piece, scene.points);
  ASSERT_EQ(kinks.size(), 1u);
  EXPECT_NEAR(kinks[0], 40, 1.5);

  SceneBuilder one(35);
  one.wire({0, 0, 9}, {85, 0, 9}, 400, 3, 0.03);
  piece.members = everyIndex(one.points);
  EXPECT_TRUE(findKinks(piece, one.points).empty());
}

TEST(Growth, FollowsAWireAcrossSmallGaps)
{
  SceneBuilder scene(37);
  scene.ground(-5, -15, 165, 15, 4);
  scene.wire({0, 0, 18}, {160, 0, 18}, 900, 4, 0.04, 70, 76);
  const std::vector<Piece> pieces = grown(scene.points);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_GT(pieces[0].model.length(), 158);
  EXPECT_LT(pieces[0].model.length(), 161);
  EXPECT_LT(pieces[0].model.sigma, 0.06);
}

TEST(Growth, TellsCloseWiresApart)
{
  for (const double apart : {0.45, 0.6, 1.0}) {
    SceneBuilder scene(39);
    scene.ground(-5, -15, 105, 15, 4);
    for (int k = 0; k < 4; ++k)
      scene.wire({0, k * apart, 10}, {100, k * apart, 10}, 700, 3, 0.03);
    const std::vector<Piece> pieces = grown(scene.points);
    ASSERT_EQ(pieces.size(), 4u) << apart;
    for (const Piece& piece : pieces) {
      const double y = piece.model.at(0).y() / apart;
      EXPECT_NEAR(y, std::round(y), 0.1 / apart);
      EXPECT_GT(piece.model.length(), 95);
    }
  }
}

/** A parabolic wire in the plane y = 0 rotated about z by \a angle degrees. */
WireWithEnds
wireWithEnds(const Point& support, double angle, double slope, double length)
{
  WireWithEnds wire;
  SpanModel& m = wire.strand.piece.model;
  m.origin = support.head<2>();
  m.direction = {std::cos(angle * M_PI / 180), std::sin(angle * M_PI / 180)};
  m.z = {support.z(), slope, 3e-4};
  m.begin = 2; // points end 2 m before the support
  m.end = length;
  wire.ends[0].place = m.at(m.begin);
  wire.ends[1].place = m.at(m.end);
  return wire;
}

TEST(Meet, IsWhereTheCurvesCross)
{
  // Both run through the support, with an angle in plan or just a kink.
  const Point support(50, 20, 30);
  for (const double angle : {0.0, 5.0, 30.0}) {
    const WireWithEnds a = wireWithEnds(support, 0, -0.1, 150);
    const WireWithEnds b = wireWithEnds(support, 180 + angle, -0.1, 120);
    const Meeting m = meet(a, 0, b, 0);
    for (const Point& place : m.places)
      EXPECT_LT((place - support).norm(), 0.1) << angle;
    EXPECT_LT(m.gap, 0.02);
  }
}

TEST(MatchEnds, PairsEveryWireWithItsContinuation)
{
  std::vector<WireWithEnds> wires;
  for (int k = 0; k < 4; ++k)
    wires.push_back(wireWithEnds({0, 0.5 * k, 20}, 0, -0.08, 100));
  for (int k = 3; k >= 0; --k)
    wires.push_back(wireWithEnds({0, 0.5 * k, 20}, 172, -0.08, 90));
  wires.push_back(wireWithEnds({3, -4, 15}, 90, -0.08, 60)); // crosses the line
  matchEnds(wires);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(wires[static_cast<std::size_t>(k)].ends[0].partner, 7 - k);
    EXPECT_EQ(wires[static_cast<std::size_t>(7 - k)].ends[0].partner, k);
    EXPECT_EQ(wires[static_cast<std::size_t>(k)].ends[0].place,
              wires[static_cast<std::size_t>(7 - k)].ends[0].place);
    EXPECT_EQ(wires[static_cast<std::size_t>(k)].ends[1].partner, -1);
  }
  EXPECT_EQ(wires[8].ends[0].partner, -1);
}

} // namespace
} // namespace linelet::powerline
