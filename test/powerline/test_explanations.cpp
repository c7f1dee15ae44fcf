// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "powerline/pieces/explanations.h"
#include "powerline/scene_builder.h"
#include "powerline/terrain/find_ground.h"

namespace linelet::powerline {
namespace {

using test::SceneBuilder;

/** Wires along x, and pieces of those of their points that lie between two y. */
class Explanations : public ::testing::Test {
protected:
  void
  wires(const std::vector<double>& places, double noise)
  {
    SceneBuilder scene(7);
    scene.ground(-5, -15, 105, 15, 4);
    for (const double y : places)
      scene.wire({0, y, 20}, {100, y, 20}, 1000, 3, noise);
    candidates_ = findCandidates(
        scene.points, findGround(scene.points, {}, false), settings_.min_height);
  }

  Piece
  between(double low, double high) const
  {
    Piece piece;
    for (std::size_t i = 0; i < candidates_.points.size(); ++i)
      if (candidates_.points[i].y() >= low && candidates_.points[i].y() < high)
        piece.members.push_back(static_cast<Index>(i));
    piece.model.direction = Eigen::Vector2d::UnitX();
    piece.model.widest = 1;
    // Twice: the first time, distances are not known yet.
    const double everywhere = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(fit(piece.model, candidates_.points, piece.members, everywhere));
    EXPECT_TRUE(fit(piece.model, candidates_.points, piece.members, piece.cut()));
    updateExtent(piece, candidates_.points);
    return piece;
  }

  std::vector<Piece>
  likelier(const std::vector<Piece>& first, const std::vector<Piece>& second) const
  {
    Growth growth(candidates_, settings_);
    return likelierPieces(growth, first, second, settings_);
  }

  PowerLineSettings settings_;
  Candidates candidates_ =
      findCandidates({{0, 0, 0}}, findGround({{0, 0, 0}}, {}, false), 1);
};

TEST_F(Explanations, OneWireInAWideBeamWinsOverItsHalves)
{
  wires({0}, 0.2);
  const std::vector<Piece> halves = {between(-1, 0), between(0, 1)};
  const std::vector<Piece> whole = {between(-1, 1)};
  EXPECT_EQ(likelier(halves, whole).size(), 1u);
  EXPECT_EQ(likelier(whole, halves).size(), 1u);
}

TEST_F(Explanations, WiresOfARackWinOverOneInTheirMiddle)
{
  wires({-0.2, 0.2}, 0.03);
  const std::vector<Piece> rack = {between(-1, 0), between(0, 1)};
  const std::vector<Piece> middle = {between(-1, 1)};
  EXPECT_EQ(likelier(middle, rack).size(), 2u);
  EXPECT_EQ(likelier(rack, middle).size(), 2u);
}

TEST_F(Explanations, WiresOfARackWinThoughOneIsMissing)
{
  wires({-0.35, 0, 0.35}, 0.03);
  const std::vector<Piece> two = {between(-1, -0.2), between(0.2, 1)};
  const std::vector<Piece> middle = {between(-1, 1)};
  EXPECT_EQ(likelier(middle, two).size(), 2u);
  EXPECT_EQ(likelier(two, middle).size(), 2u);
}

TEST_F(Explanations, ASliceOfAWideWireIsNone)
{
  wires({0}, 0.2);
  const Piece whole = between(-1, 1);
  for (const double y : {-0.2, 0.0, 0.1}) {
    const Piece slice = between(y - 0.06, y + 0.06);
    EXPECT_EQ(likelier({whole}, {slice}).front().members, whole.members);
    EXPECT_EQ(likelier({slice}, {whole}).front().members, whole.members);
  }
}

TEST_F(Explanations, OfNarrowWiresTheFirstStay)
{
  wires({0}, 0.03);
  const Piece all = between(-1, 1), most = between(-0.05, 1);
  ASSERT_LT(most.members.size(), all.members.size());
  EXPECT_EQ(likelier({all}, {most}).front().members, all.members);
  EXPECT_EQ(likelier({most}, {all}).front().members, most.members);
}

TEST_F(Explanations, WithoutARivalTheFirstStayAndTheSecondGo)
{
  wires({-6, 6}, 0.03);
  const std::vector<Piece> result = likelier({between(-7, -5)}, {between(5, 7)});
  ASSERT_EQ(result.size(), 1u);
  EXPECT_LT(result.front().model.at(0).y(), 0);
  EXPECT_TRUE(likelier({}, {}).empty());
}

} // namespace
} // namespace linelet::powerline
