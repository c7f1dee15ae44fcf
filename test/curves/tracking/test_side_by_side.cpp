// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Curves side by side, which look like a surface.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <linelet/curves/reconstruct_curves.h>

#include "network_distance.h"

using namespace linelet;

namespace {

// A point every two meters on wires six meters apart: any ball around one of them that
// holds enough points is flat. Roofs show how densely surfaces of this scan are
// sampled.
TEST(SideBySide, SparseCurvesAreNotASurface)
{
  constexpr int count = 6;
  const auto at = [](int wire, double x) {
    return Point(x, 6.0 * wire, 25 + 20 * std::pow(x / 500 - 1, 2));
  };
  for (const unsigned seed : {31U, 32U, 33U}) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> noise(0, 0.05);
    Points points;
    for (int roof = 0; roof < 10; ++roof)
      for (int k = 0; k < 250; ++k)
        points.emplace_back(
            100 * roof + 15 * unit(random), 50 + 15 * unit(random), 6 + noise(random));
    for (int wire = 0; wire < count; ++wire)
      for (int k = 0; k < 500; ++k)
        points.push_back(at(wire, 1000 * unit(random)) +
                         Point(noise(random), noise(random), noise(random)));
    std::shuffle(points.begin(), points.end(), random);
    const CurveNetwork network = reconstructCurves(points);
    EXPECT_GE(shareNear(network, at, count, 5, 995, 0.15), 0.9);
  }
}

// A wide beam spreads the points of a wire over a ribbon many times as wide as it is
// high; three side by side look like a surface from scales of a meter on.
TEST(SideBySide, RibbonsAreNotASurface)
{
  const auto at = [](int wire, double x) {
    return Point(x, 0.9 * (wire - 1), 9 + 0.002 * (x - 20) * (x - 20));
  };
  for (unsigned seed = 11; seed < 31; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> noise(0, 0.016);
    Points points;
    for (int k = 0; k < 48000; ++k)
      points.emplace_back(40 * unit(random), 20 * unit(random) - 10, noise(random));
    for (int wire = 0; wire < 3; ++wire)
      for (int k = 0; k < 400; ++k)
        points.push_back(at(wire, 40 * unit(random)) +
                         Point(0, 0.34 * (unit(random) - 0.5), noise(random)));
    const CurveNetwork network = reconstructCurves(points);
    EXPECT_GE(shareNear(network, at, 3, 1, 39, 0.1), 0.9);
    // Each is one line in the middle, not one along either edge.
    EXPECT_LE(length(network), 1.05 * 3 * 40);
    for (const Curve& curve : network.curves)
      for (const Point& p : curve.points) {
        double nearest = 1e300;
        for (int wire = 0; wire < 3; ++wire)
          nearest = std::min(nearest, (at(wire, p.x()) - p).norm());
        EXPECT_LE(nearest, 0.15);
      }
  }
}

// Two ribbons with air between them are two wires, however wide they are.
TEST(SideBySide, RibbonsOfATwinBundleAreTwo)
{
  const auto at = [](int wire, double x) {
    return Point(x, 0.4 * (wire - 0.5), 9 + 0.0005 * (x - 60) * (x - 60));
  };
  for (const unsigned seed : {14U, 15U, 16U}) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> noise(0, 0.03);
    Points points;
    for (int k = 0; k < 20000; ++k)
      points.emplace_back(120 * unit(random), 20 * unit(random) - 10, noise(random));
    for (int wire = 0; wire < 2; ++wire)
      for (int k = 0; k < 360; ++k)
        points.push_back(at(wire, 120 * unit(random)) +
                         Point(0, 0.24 * (unit(random) - 0.5), noise(random)));
    const CurveNetwork network = reconstructCurves(points);
    EXPECT_GE(shareNear(network, at, 2, 1, 119, 0.1), 0.95);
    EXPECT_LE(length(network), 1.05 * 2 * 122);
  }
}

} // namespace
