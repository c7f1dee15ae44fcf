// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Where wires are close together, each ends at its own attachment point.

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include <linelet/powerline/extract_power_lines.h>

#include "powerline/scene_builder.h"

namespace linelet::powerline {
namespace {

using test::SceneBuilder;

constexpr double rack_spacing = 0.35; // meters between wires above each other
constexpr double top = 9;             // meters, of the rack
constexpr double span = 40;           // meters to either side of the pole
constexpr double a = 400;             // catenary parameter, meters

/** A wire of the scene from the pole at the origin. */
struct TrueWire {
  Point pole, far;

  TrueWire(double level, double x, double y = 0)
      : pole(0, y, top - rack_spacing * level), far(x, y, pole.z())
  {
  }

  double
  distance(const Wire& wire) const
  {
    double worst = 0;
    for (double s = 0; s <= span; s += 1)
      worst =
          std::max(worst, wire.curve.distance(SceneBuilder::onWire(pole, far, a, s)));
    return worst;
  }
};

void
expectEveryWireToKeepItsEnd(const std::vector<TrueWire>& truth)
{
  for (const std::uint32_t seed : {1, 2, 3, 4, 5}) {
    SceneBuilder scene(seed);
    scene.ground(-span - 2, -12, span + 2, 12, 6);
    scene.box({-0.1, -0.1, 0}, {0.1, 0.1, top}, 60);
    for (const TrueWire& wire : truth)
      scene.wire(wire.pole, wire.far, a, 4, 0.02);
    const PowerLineNetwork network = extractPowerLines(scene.points);
    EXPECT_EQ(network.wires.size(), truth.size()) << "seed " << seed;
    for (const TrueWire& wire : truth) {
      double nearest = span;
      for (const Wire& found : network.wires)
        nearest = std::min(nearest, wire.distance(found));
      EXPECT_LT(nearest, 0.08) << "seed " << seed << ", wire at " << wire.pole.z()
                               << " m to x = " << wire.far.x();
    }
  }
}

TEST(AttachmentPoint, IsSharedByWiresOfOneLevelOfARack)
{
  std::vector<TrueWire> truth;
  for (int level = 0; level < 4; ++level)
    for (const double x : {-span, span})
      truth.emplace_back(level, x);
  expectEveryWireToKeepItsEnd(truth);
}

// The two lower wires end at the pole, and another begins .8 m from the lowest.
TEST(AttachmentPoint, IsNotHalfwayToAWireOfAnotherLevel)
{
  std::vector<TrueWire> truth;
  for (int level = 0; level < 4; ++level)
    truth.emplace_back(level, -span);
  for (const int level : {0, 1})
    truth.emplace_back(level, span);
  truth.emplace_back(4.5, span, 0.6);
  expectEveryWireToKeepItsEnd(truth);
}

} // namespace
} // namespace linelet::powerline
