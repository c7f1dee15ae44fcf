// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// What the reconstruction takes for curves in simulated scans.

#include <cstdint>

#include <gtest/gtest.h>

#include <bench/measures/scene_scores.h>
#include <bench/scenes/scene.h>
#include <linelet/curves/reconstruct_curves.h>

namespace {

using namespace linelet;
using namespace linelet::bench;

constexpr std::uint8_t ground_class = 2;

TEST(CurvesOfScenes, RoofsOfATownAreNone)
{
  // Ridges, eaves, gable ends and rows of pulses on roofs: next to them lies a surface.
  double wrong = 0;
  for (const std::uint32_t seed : {4, 5}) {
    SceneSettings settings;
    settings.kind = SceneKind::TownEmpty;
    settings.seed = seed;
    const SceneScan scan = simulateScene(settings);
    Points points;
    for (std::size_t i = 0; i < scan.points.size(); ++i)
      if (scan.classification[i] != ground_class)
        points.push_back(scan.points[i]);
    wrong += scoreSceneCurves(reconstructCurves(points), scan).falseLength();
  }
  EXPECT_LT(wrong, 300); // meters, out of kilometers of edges
}

} // namespace
