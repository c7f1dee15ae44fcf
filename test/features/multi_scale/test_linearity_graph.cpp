// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "graphs_by_hand.h"

// The graphs are worked out by hand in the comments, from the definitions of A, A_j,
// delta and O_m alone.

namespace linelet::test {

namespace {

TEST(LinearityGraph, FindsExtremaOfTwoPeaks)
{
  const LinearityGraph graph = read(two_peaks);
  // Minima at 1 and 4; the rising end is a maximum, and so is the beginning.
  EXPECT_EQ(graph.minima, (std::vector<std::size_t>{1, 4}));
  ASSERT_EQ(graph.maxima.size(), 3u);
  EXPECT_EQ(graph.maxima[0].scale, 0u);
  EXPECT_EQ(graph.maxima[1].scale, 2u);
  EXPECT_EQ(graph.maxima[2].scale, 5u);
  EXPECT_EQ(graph.maxima[0].left, 0u);
  EXPECT_EQ(graph.maxima[0].right, 1u);
  EXPECT_EQ(graph.maxima[1].left, 1u);
  EXPECT_EQ(graph.maxima[1].right, 4u);
  EXPECT_EQ(graph.maxima[2].left, 4u);
  EXPECT_EQ(graph.maxima[2].right, 5u);
  EXPECT_DOUBLE_EQ(graph.largest, 0.9);
}

TEST(LinearityGraph, FallingAndRisingGraphsPeakAtTheirEnds)
{
  EXPECT_EQ(read({0.9, 0.6, 0.3}).scale(), 0u);
  const LinearityGraph rising = read({0.3, 0.6, 0.9});
  ASSERT_EQ(rising.maxima.size(), 1u);
  EXPECT_EQ(rising.scale(), 2u);
}

TEST(LinearityGraph, PlateauIsOneMaximumAtItsFirstScale)
{
  // A clean line up to a corner: 1 until the corner is reached.
  const LinearityGraph graph = read({1, 1, 1, 0.5, 0.4});
  ASSERT_EQ(graph.maxima.size(), 1u);
  EXPECT_EQ(graph.scale(), 0u);
  EXPECT_EQ(graph.maxima[0].right, 4u);
  // Rounding creates no extrema on a plateau.
  const LinearityGraph rough = read({1, 1 - 1e-9, 1 - 1e-16, 1 - 1e-8, 0.5});
  ASSERT_EQ(rough.maxima.size(), 1u);
  EXPECT_EQ(rough.scale(), 0u);
  EXPECT_TRUE(rough.minima.empty());
}

TEST(LinearityGraph, PlateauWithTooFewNeighborsStartsWhereThereAreEnough)
{
  const LinearityGraph graph = read({1, 1, 1, 0.5}, {}, {3, 6, 7, 9});
  ASSERT_EQ(graph.maxima.size(), 1u);
  EXPECT_EQ(graph.scale(), 2u);
  EXPECT_EQ(graph.maxima[0].left, 2u);
  EXPECT_NEAR(graph.area, 3.5, 1e-12); // A still begins at the first defined scale
}

TEST(LinearityGraph, PlateauIsOneMinimum)
{
  // The valley floor 1..2: the left hill ends where it begins, the right one begins
  // where it ends, and A runs through it: .8 + .1 + .1 = 1.
  const LinearityGraph graph = read({0.8, 0.1, 0.1, 0.6});
  EXPECT_EQ(graph.minima, (std::vector<std::size_t>{2}));
  EXPECT_NEAR(graph.area, 1.0, 1e-12);
  ASSERT_EQ(graph.maxima.size(), 2u);
  EXPECT_EQ(graph.maxima[0].right, 1u);
  EXPECT_EQ(graph.maxima[1].left, 2u);
  EXPECT_NEAR(graph.maxima[0].area_fraction, 0.9, 1e-12);
  EXPECT_NEAR(graph.maxima[1].area_fraction, 0.7, 1e-12);
}

TEST(LinearityGraph, AFlatLowEndIsNotAMinimum)
{
  // Converged after the hill: the flat end is not a minimum, so A is the whole graph.
  const LinearityGraph graph = read({0.2, 0.9, 0.4, 0.4, 0.4});
  EXPECT_TRUE(graph.minima.empty());
  EXPECT_NEAR(graph.area, 2.3, 1e-12);
  EXPECT_EQ(graph.scale(), 1u);
}

TEST(LinearityGraph, FlatHighEndIsAMaximum)
{
  const LinearityGraph graph = read({0.5, 0.2, 0.7, 0.7});
  ASSERT_EQ(graph.maxima.size(), 2u);
  EXPECT_EQ(graph.maxima[1].scale, 2u);
  EXPECT_EQ(graph.maxima[1].right, 3u);
}

TEST(LinearityGraph, FlatGraphIsAMaximum)
{
  const LinearityGraph graph = read({0.4, 0.4, 0.4});
  ASSERT_EQ(graph.maxima.size(), 1u);
  EXPECT_EQ(graph.scale(), 0u);
  EXPECT_NEAR(graph.maxima[0].score, 0.4 + 1, 1e-12);
  EXPECT_NEAR(graph.blend, 0.4, 1e-12);
}

TEST(LinearityGraph, OneScale)
{
  for (const GraphIntegral integral :
       {GraphIntegral::Scales, GraphIntegral::LogRadius, GraphIntegral::Radius}) {
    LinearityGraphSettings settings;
    settings.integral = integral;
    const LinearityGraph graph = read({0.3}, settings);
    ASSERT_EQ(graph.maxima.size(), 1u);
    EXPECT_EQ(graph.scale(), 0u);
    // An integral over no width is 0, and so is the hill's share of it.
    EXPECT_EQ(graph.area, integral == GraphIntegral::Scales ? 0.3 : 0.0);
    EXPECT_EQ(graph.maxima[0].area_fraction, 1);
    EXPECT_NEAR(graph.maxima[0].score, 1.3, 1e-12);
    EXPECT_NEAR(graph.blend, 0.3, 1e-12);
  }
}

TEST(LinearityGraph, OfEqualMaximaTheSmallerScaleWins)
{
  // Two equal hills: they differ only in 1 - k/K, which favors the first anyway.
  const LinearityGraph hills = read({0.1, 0.6, 0.1, 0.6, 0.1});
  ASSERT_EQ(hills.maxima.size(), 2u);
  EXPECT_EQ(hills.scale(), 1u);
  // All zero: A = 0, and all terms except the fraction vanish.
  const LinearityGraph zero = read({0, 0, 0});
  EXPECT_EQ(zero.scale(), 0u);
  EXPECT_NEAR(zero.maxima[0].score, 1, 1e-12);
  EXPECT_NEAR(zero.blend, 0.05, 1e-12); // .5 - .5 clamped
}

TEST(LinearityGraph, ExactTieGoesToTheSmallerScale)
{
  // A product score with CL 0 everywhere outside a valley "below 0" is impossible, so
  // the tie is made of clamped terms. K = 4. j = 0: (4/4) .25 + A_0/A; j = 2: (2/4) .5
  // + A_2/A - delta/2. A = .25 + 0 = .25 (minimum at 1); A_0/A = 1, A_2/A = .5/.25 ->
  // 1; delta_0 = 0, delta_2 = .5 - max(0, .5) = 0 with a flat end. Both scores 1.25.
  const LinearityGraph graph = read({0.25, 0, 0.5, 0.5});
  ASSERT_EQ(graph.maxima.size(), 2u);
  EXPECT_EQ(graph.maxima[0].score, 1.25);
  EXPECT_EQ(graph.maxima[1].score, 1.25);
  EXPECT_EQ(graph.scale(), 0u);
}

TEST(LinearityGraph, FloorOfNeighborsCountsThePointItself)
{
  // Seven points make a scale eligible, six do not.
  EXPECT_EQ(read({0.9, 0.5}, {}, {7, 20}).scale(), 0u);
  EXPECT_EQ(read({0.9, 0.5}, {}, {6, 20}).scale(), 1u);
  // Maxima count from the first eligible scale, A from the beginning of the graph.
  const LinearityGraph graph = read({0.9, 0.5, 0.3, 0.4, 0.1}, {}, {4, 8, 9, 10, 20});
  ASSERT_EQ(graph.maxima.size(), 2u);
  EXPECT_EQ(graph.maxima[0].scale, 1u);
  EXPECT_EQ(graph.maxima[0].left, 1u);
  EXPECT_NEAR(graph.area, 1.7, 1e-12);
  EXPECT_NEAR(graph.maxima[0].area_fraction, 0.8 / 1.7, 1e-12);
}

TEST(LinearityGraph, NoScaleWithEnoughNeighbors)
{
  const LinearityGraph graph = read({0.9, 0.5, 0.7}, {}, {3, 4, 6});
  EXPECT_EQ(graph.scale(), LinearityGraph::none);
  EXPECT_TRUE(graph.maxima.empty());
  EXPECT_TRUE(std::isnan(graph.blend));
  EXPECT_NEAR(graph.area, 1.4, 1e-12); // start points still have their area
  EXPECT_NEAR(graph.largest, 0.9, 1e-12);
}

TEST(LinearityGraph, UndefinedScalesTakeNoPart)
{
  const LinearityGraph graph = read({nan, 0.5, nan, 0.9, 0.2}, {}, {1, 7, 7, 8, 9});
  EXPECT_EQ(graph.scale(), 3u);
  EXPECT_EQ(graph.maxima[0].left, 1u);
  EXPECT_NEAR(graph.area, 1.6, 1e-12);
  // k_j counts all scales: (1 - 3/5) .9 + 1 - .4/2.
  EXPECT_NEAR(graph.maxima[0].score, 0.9 * 2 / 5 + 1 - 0.2, 1e-12);
}

TEST(LinearityGraph, NothingDefined)
{
  for (const auto& values : {std::vector<double>{}, std::vector<double>{nan, nan}}) {
    const LinearityGraph graph = read(values);
    EXPECT_EQ(graph.scale(), LinearityGraph::none);
    EXPECT_TRUE(std::isnan(graph.area));
    EXPECT_TRUE(std::isnan(graph.largest));
    EXPECT_TRUE(std::isnan(graph.blend));
  }
}

TEST(LinearityGraph, RefusesListsOfDifferentLength)
{
  EXPECT_THROW(linelet::readLinearityGraph({0.5, 0.5}, {7}, {1, 2}),
               std::invalid_argument);
}

TEST(LinearityGraph, BlendIsClamped)
{
  EXPECT_NEAR(read({1, 1}).blend, 0.95, 1e-12);
  EXPECT_NEAR(read({0.01, 0.01}).blend, 0.05, 1e-12);
}

TEST(LinearityGraph, HoldsItsPromisesOnRandomGraphs)
{
  const unsigned seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 engine(seed);
  const auto random = [&engine] { return static_cast<std::uint32_t>(engine()); };
  for (int round = 0; round < 2000; ++round) {
    const std::size_t size = 1 + random() % 12;
    std::vector<double> values;
    std::vector<std::uint32_t> counts;
    std::uint32_t count = 0;
    for (std::size_t k = 0; k < size; ++k) {
      // Few distinct values, so that plateaus and ties are common.
      values.push_back(random() % 7 == 0 ? nan : 0.1 * (random() % 11));
      counts.push_back(count += random() % 5);
    }
    LinearityGraphSettings settings;
    settings.score = random() % 2 ? ScaleScore::Sum : ScaleScore::Product;
    settings.integral = static_cast<GraphIntegral>(random() % 3);
    const LinearityGraph graph = read(values, settings, counts);
    bool eligible = false;
    for (std::size_t k = 0; k < size; ++k)
      eligible = eligible || (!std::isnan(values[k]) && counts[k] >= 7);
    EXPECT_EQ(graph.best != LinearityGraph::none, eligible);
    for (const auto& maximum : graph.maxima) {
      EXPECT_LE(maximum.left, maximum.scale);
      EXPECT_LE(maximum.scale, maximum.right);
      EXPECT_GE(counts[maximum.scale], 7u);
      EXPECT_LE(maximum.score, graph.maxima[graph.best].score);
      EXPECT_GE(maximum.area_fraction, 0);
      EXPECT_LE(maximum.area_fraction, 1);
      EXPECT_GE(maximum.delta, -1e-12);
      // Nothing between j- and j+ is higher.
      for (std::size_t k = maximum.left; k <= maximum.right; ++k) {
        EXPECT_FALSE(values[k] > values[maximum.scale] + linelet::flat_linearity);
      }
    }
    if (eligible) {
      EXPECT_GE(graph.blend, 0.05);
      EXPECT_LE(graph.blend, 0.95);
    }
  }
}

} // namespace

} // namespace linelet::test
