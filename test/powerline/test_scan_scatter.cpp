// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "powerline/pieces/scan_scatter.h"

using namespace linelet::powerline;

namespace {

using Samples = std::vector<ScanScatter::Sample>;

TEST(ScanScatter, IsThatOfMostPoints)
{
  // Many rows of few points outnumber the wires, but not their points.
  const Samples wires = {
      {0.04, 600}, {0.042, 500}, {0.038, 700}, {0.15, 20}, {0.16, 30}, {0.14, 25}};
  const ScanScatter scatter(wires);
  for (std::size_t w = 0; w < 3; ++w)
    EXPECT_LT(scatter.excess(wires[w]), 1) << wires[w].rms;
  for (std::size_t w = 3; w < wires.size(); ++w)
    EXPECT_GT(scatter.excess(wires[w]), 2.5) << wires[w].rms;
}

TEST(ScanScatter, FewPointsTellLess)
{
  const ScanScatter scatter({{0.04, 600}, {0.041, 500}, {0.039, 700}});
  EXPECT_GT(scatter.excess({0.08, 100}), scatter.excess({0.08, 5}));
  // ln 2 over the deviation of the scatter, .15, and that of 100 points, 1 / 20.
  EXPECT_NEAR(scatter.excess({0.08, 100}), std::log(2) / std::hypot(0.15, 0.05), 1e-12);
}

TEST(ScanScatter, NarrowerIsNoExcess)
{
  const ScanScatter scatter({{0.04, 600}, {0.041, 500}});
  EXPECT_EQ(scatter.excess({0.01, 50}), 0);
}

TEST(ScanScatter, HasNoUnit)
{
  const Samples meters = {{0.04, 60}, {0.05, 50}, {0.07, 20}};
  Samples feet = meters;
  for (ScanScatter::Sample& wire : feet)
    wire.rms /= 0.3048;
  for (std::size_t w = 0; w < meters.size(); ++w)
    EXPECT_NEAR(ScanScatter(meters).excess(meters[w]),
                ScanScatter(feet).excess(feet[w]),
                1e-12);
}

TEST(ScanScatter, IsUnknownWithoutWires)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Samples& wires : {Samples{}, Samples{{0, 10}}, Samples{{nan, 10}}}) {
    const ScanScatter scatter(wires);
    EXPECT_EQ(scatter.excess({0, 10}), 0);
    EXPECT_EQ(scatter.excess({nan, 10}), 0);
    EXPECT_EQ(scatter.excess({0.05, 0}), 0);
  }
}

TEST(ScanScatter, PriorHasHeavyTails)
{
  EXPECT_EQ(logPriorOfScatter(0), 0);
  EXPECT_NEAR(logPriorOfScatter(3), -2 * std::log(4), 1e-12);
  EXPECT_GT(logPriorOfScatter(10), -0.5 * 10 * 10); // a normal one
}

} // namespace
