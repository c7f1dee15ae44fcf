// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Scores of the scales of a graph, their terms and weights, worked out by hand.

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "graphs_by_hand.h"

namespace linelet::test {

namespace {

TEST(LinearityGraph, ScoresByProductAsWorkedOutByHand)
{
  const LinearityGraph graph = read(two_peaks);
  // A = .9 + .3 + .8 + .6 + .2 = 2.8 (up to the last minimum).
  EXPECT_NEAR(graph.area, 2.8, 1e-12);
  // j = 0: A_j = 1.2, delta = .9 - max(.9, .3) = 0; O = .9 + 1.2/2.8.
  EXPECT_NEAR(graph.maxima[0].area_fraction, 1.2 / 2.8, 1e-12);
  EXPECT_NEAR(graph.maxima[0].delta, 0, 1e-12);
  EXPECT_NEAR(graph.maxima[0].score, 0.9 + 1.2 / 2.8, 1e-12);
  // j = 2: A_j = 1.9, delta = .8 - .3 = .5; O = (4/6) .8 + 1.9/2.8 - .25.
  EXPECT_NEAR(graph.maxima[1].area_fraction, 1.9 / 2.8, 1e-12);
  EXPECT_NEAR(graph.maxima[1].delta, 0.5, 1e-12);
  EXPECT_NEAR(graph.maxima[1].score, 0.8 * 4 / 6 + 1.9 / 2.8 - 0.25, 1e-12);
  // j = 5: A_j = .6, delta = .4 - max(.2, .4) = 0; O = (1/6) .4 + .6/2.8.
  EXPECT_NEAR(graph.maxima[2].score, 0.4 / 6 + 0.6 / 2.8, 1e-12);
  // 1.329 > .962 > .281; mu = 1.2/5.6 + .9 - .5.
  EXPECT_EQ(graph.scale(), 0u);
  EXPECT_NEAR(graph.blend, 1.2 / 5.6 + 0.4, 1e-12);
}

TEST(LinearityGraph, ScoresBySumAsWorkedOutByHand)
{
  LinearityGraphSettings settings;
  settings.score = ScaleScore::Sum;
  const LinearityGraph graph = read(two_peaks, settings);
  EXPECT_NEAR(graph.maxima[0].score, 0.9 - 0.0 + 1.2 / 2.8, 1e-12);
  EXPECT_NEAR(graph.maxima[1].score, 0.8 - 2.0 / 6 + 1.9 / 2.8 - 0.25, 1e-12);
  // .4 - 5/6 < 0: the first term is clamped to 0.
  EXPECT_NEAR(graph.maxima[2].score, 0.6 / 2.8, 1e-12);
}

TEST(LinearityGraph, BothReadingsOfTheScoreCanDisagree)
{
  // j = 1: CL .6, A_j = .2 + .6 + .4 = 1.2; j = 3: CL .95, A_j = .4 + .95 + .3 = 1.65;
  // A = 2.45 + .3 = 2.45 (minima at 2 and 4: .2 + .6 + .4 + .95 + .3).
  const std::vector<double> values = {0.2, 0.6, 0.4, 0.95, 0.3, 0.35};
  LinearityGraphSettings settings;
  const double area = 2.45;
  const LinearityGraph product = read(values, settings);
  EXPECT_NEAR(product.maxima[0].score, 0.6 * 5 / 6 + 1.2 / area - 0.1, 1e-12);
  EXPECT_NEAR(product.maxima[1].score, 0.95 * 3 / 6 + 1.65 / area - 0.275, 1e-12);
  EXPECT_EQ(product.scale(), 1u); // .890 > .873
  settings.score = ScaleScore::Sum;
  const LinearityGraph sum = read(values, settings);
  EXPECT_NEAR(sum.maxima[0].score, 0.6 - 1.0 / 6 + 1.2 / area - 0.1, 1e-12);
  EXPECT_NEAR(sum.maxima[1].score, 0.95 - 3.0 / 6 + 1.65 / area - 0.275, 1e-12);
  EXPECT_EQ(sum.scale(), 3u); // .848 > .823
}

TEST(LinearityGraph, AreaOverTheRadius)
{
  LinearityGraphSettings settings;
  settings.integral = GraphIntegral::Radius;
  const LinearityGraph graph = read(two_peaks, settings);
  // Trapezoids over 1, 2, 4, 8, 16: 1 (.9+.3)/2 + 2 (.3+.8)/2 + 4 (.8+.6)/2 + 8
  // (.6+.2)/2.
  const double area = 0.6 + 1.1 + 2.8 + 3.2;
  EXPECT_NEAR(graph.area, area, 1e-12);
  EXPECT_NEAR(graph.maxima[0].area_fraction, 0.6 / area, 1e-12);
  EXPECT_NEAR(graph.maxima[1].area_fraction, 7.1 / area, 1e-12);
  // 16 (.2+.4)/2 = 4.8 lies beyond the last minimum.
  EXPECT_NEAR(graph.maxima[2].area_fraction, 4.8 / area, 1e-12);
}

TEST(LinearityGraph, AreaOverTheLogarithmOfTheRadius)
{
  LinearityGraphSettings settings;
  settings.integral = GraphIntegral::LogRadius;
  const LinearityGraph graph = read(two_peaks, settings);
  const double step = std::log(2.0), area = (0.6 + 0.55 + 0.7 + 0.4) * step;
  EXPECT_NEAR(graph.area, area, 1e-12);
  EXPECT_NEAR(graph.maxima[1].area_fraction, (0.55 + 0.7 + 0.4) * step / area, 1e-12);
}

TEST(LinearityGraph, AreaOfTheWholeGraphWithoutAMinimum)
{
  // One hill: no interior minimum, so A is the whole area and A_j = A.
  const LinearityGraph graph = read({0.2, 0.7, 0.5});
  EXPECT_TRUE(graph.minima.empty());
  EXPECT_NEAR(graph.area, 1.4, 1e-12);
  ASSERT_EQ(graph.maxima.size(), 1u);
  EXPECT_NEAR(graph.maxima[0].area_fraction, 1, 1e-12);
  EXPECT_NEAR(graph.maxima[0].delta, 0.2, 1e-12);
  EXPECT_NEAR(graph.maxima[0].score, 0.7 * 2 / 3 + 1 - 0.1, 1e-12);
  EXPECT_NEAR(graph.blend, 0.5 + 0.2, 1e-12);
}

TEST(LinearityGraph, AreaOfTheWholeGraphWhereAsked)
{
  LinearityGraphSettings settings;
  settings.area_end = linelet::AreaEnd::WholeGraph;
  const LinearityGraph graph = read(two_peaks, settings);
  // A = .9 + .3 + .8 + .6 + .2 + .4; the hills are as large as before.
  EXPECT_NEAR(graph.area, 3.2, 1e-12);
  EXPECT_NEAR(graph.maxima[1].area_fraction, 1.9 / 3.2, 1e-12);
  EXPECT_NEAR(graph.maxima[2].area_fraction, 0.6 / 3.2, 1e-12);
  // Without a minimum there is no other end.
  EXPECT_EQ(read({0.2, 0.7, 0.5}, settings).area, read({0.2, 0.7, 0.5}).area);
}

TEST(LinearityGraph, WeighsTheTermsOfTheScore)
{
  const std::vector<std::uint32_t> neighbors = {10, 20, 40, 90, 200, 400};
  LinearityGraphSettings settings;
  const auto middle = [&](const char* weights) {
    settings.score_weights = linelet::ScoreWeights(weights);
    return read(two_peaks, settings, neighbors).maxima[1].score;
  };
  // The second maximum: k/K = 2/6, CL .8, A_j/A = 1.9/2.8, delta .5 (see above).
  const double area = 1.9 / 2.8;
  EXPECT_NEAR(middle(""), 0.8 * 4 / 6 + area - 0.25, 1e-12);
  EXPECT_NEAR(middle("linearity=2"), 1.6 * 4 / 6 + area - 0.25, 1e-12);
  EXPECT_NEAR(middle("scale=-2"), 0.8 * 2 / 6 + area - 0.25, 1e-12);
  EXPECT_NEAR(middle("scale=-4"), 0 + area - 0.25, 1e-12);     // clamped to 0
  EXPECT_NEAR(middle("scale=3"), 1 + area - 0.25, 1e-12);      // 1.6, clamped to 1
  EXPECT_NEAR(middle("linearity=-1"), 0 + area - 0.25, 1e-12); // nothing remains of it
  EXPECT_NEAR(middle("area=0,depth=0"), 0.8 * 4 / 6, 1e-12);
  const double published = 0.8 * 4 / 6 + area - 0.25;
  // .8 - .3 on the way up, .8 - .6 on the way down.
  EXPECT_NEAR(middle("step=0.1"), published + 0.1 * 0.5, 1e-12);
  // From the minimum at 1 to that at 4.
  EXPECT_NEAR(middle("width=0.1"), published + 0.1 * 3 / 6, 1e-12);
  // 40 of 400 within 4 of 32.
  EXPECT_NEAR(middle("neighbors=1"), published + 40. / 400 * 32 / 4, 1e-12);
  EXPECT_NEAR(middle("second=0.3"), published + 0.3, 1e-12);
  EXPECT_NEAR(read(two_peaks, settings, neighbors).maxima[0].score,
              read(two_peaks).maxima[0].score,
              1e-12)
      << "only the second maximum is voted up";
  settings.score = ScaleScore::Sum;
  EXPECT_NEAR(middle("linearity=2,scale=-1.5"), 1.6 - 0.5 + area - 0.25, 1e-12);
}

TEST(LinearityGraph, AWeightCanChangeTheOptimalScale)
{
  LinearityGraphSettings settings;
  EXPECT_EQ(read(two_peaks).scale(), 0u); // 1.329 against .962
  settings.score_weights.second = 0.4;
  EXPECT_EQ(read(two_peaks, settings).scale(), 2u);
}

TEST(ScoreWeights, AreReadAsTheyAreWritten)
{
  const linelet::ScoreWeights some("depth=0.1,second=-3e-5");
  EXPECT_EQ(some.name(), "depth=0.1,second=-3e-05");
  EXPECT_EQ(linelet::ScoreWeights().name(), "published");
  EXPECT_EQ(linelet::ScoreWeights("published").depth, -0.5);
  EXPECT_EQ(linelet::ScoreWeights(some.name()).name(), some.name());
  EXPECT_EQ(linelet::ScoreWeights("").name(), linelet::ScoreWeights().name());
  for (const char* wrong : {"depth",
                            "depth=",
                            "depth=x",
                            "depth=1x",
                            "depth=inf",
                            "depth=nan",
                            "deep=1",
                            "1",
                            ",depth=1",
                            "depth=1;area=2"})
    EXPECT_THROW(linelet::ScoreWeights{wrong}, std::invalid_argument) << wrong;
}

} // namespace

} // namespace linelet::test
