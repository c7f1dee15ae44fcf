// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <linelet/io/file_error.h>

#include "hazard_scene.h"

namespace {

using namespace linelet;
using namespace linelet::test;

TEST(Limits, OfTheStandardsRiseWithTheVoltage)
{
  const ClearanceLimits none = uniformLimits(5);
  // EN 50341-1: 5 m + Del but 6 m at least; 1.5 m + Del; 1 m + Dpp.
  const ClearanceLimits high = readLimits("en50341:110", none);
  EXPECT_NEAR(high.of(HazardKind::Ground).high, 6.0, 1e-12);
  EXPECT_NEAR(high.of(HazardKind::Vegetation).medium, 2.5, 1e-12);
  EXPECT_NEAR(high.of(HazardKind::Wire).medium, 2.15, 1e-12);
  EXPECT_NEAR(readLimits("en50341:380", none).of(HazardKind::Ground).high, 7.8, 1e-12);
  // NESC rule 232: 18.5 ft, plus 0.4 in per kV above 22 kV to ground.
  EXPECT_NEAR(readLimits("nesc:12", none).of(HazardKind::Ground).high, 5.639, 1e-3);
  EXPECT_NEAR(readLimits("nesc:345", none).of(HazardKind::Ground).high,
              0.3048 * (18.5 + 0.4 / 12 * (345 * 1.05 / std::sqrt(3.0) - 22)),
              1e-9);
  for (const char* name : {"en50341:", "en50341:high", "nesc:1e9", "nesc:-3"})
    EXPECT_THROW(readLimits(name, none), std::invalid_argument) << name;
  for (double voltage = 3; voltage <= 750; voltage += 1)
    for (const char* standard : {"en50341:", "nesc:"})
      for (const ClearanceLimits::Row& row :
           readLimits(standard + std::to_string(voltage), none).rows) {
        ASSERT_LE(row.high, row.medium) << standard << voltage;
        ASSERT_LE(row.medium, row.low) << standard << voltage;
      }
}

TEST(Limits, AreReadFromATableOrRefused)
{
  const std::string path = testing::TempDir() + "linelet_limits.txt";
  std::ofstream(path) << "# meters\nground 6 7 8.5\n\nfall_in 0 1 3 # trees\n";
  const ClearanceLimits limits = readLimits(path, uniformLimits(5));
  EXPECT_EQ(limits.of(HazardKind::Ground).low, 8.5);
  EXPECT_EQ(limits.of(HazardKind::FallIn).low, 3);
  EXPECT_EQ(limits.of(HazardKind::Vegetation).low, 5);
  EXPECT_EQ(limits.severity(HazardKind::Ground, 6.5), Severity::Medium);
  EXPECT_EQ(limits.severity(HazardKind::Ground, 8.5), Severity::None);
  for (const char* bad : {"grund 6 7 8",
                          "ground 6 7",
                          "ground 8 7 6",
                          "ground 6 7 8 9",
                          "ground 6 7 nan",
                          "ground 6 seven 8"}) {
    std::ofstream(path) << "# one\n" << bad << '\n';
    try {
      readLimits(path, uniformLimits(5));
      ADD_FAILURE() << bad;
    }
    catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos) << bad;
    }
  }
  EXPECT_THROW(readLimits("/nowhere/limits", uniformLimits(5)), io::FileError);
}

TEST(States, RunOnInIdsAndLowerTheWiresWithTheHeat)
{
  Scene scene;
  const io::UsablePoints usable(scene.cloud);
  HazardSettings settings;
  settings.limits = "";
  settings.conductor = "Hawk";
  settings.states = {"80C", "0C,wind=500Pa"};
  const std::vector<Hazards> states =
      findHazardsAtStates(scene.network, scene.cloud, usable, settings, 12);
  ASSERT_EQ(states.size(), 4U); // as scanned, hot, wind from both sides
  EXPECT_EQ(states[0].state, "as scanned");
  EXPECT_EQ(states[1].state, "80C");
  EXPECT_TRUE(states[0].moved.wires.empty());
  ASSERT_EQ(states[1].moved.wires.size(), 1U);
  EXPECT_LT(states[1].moved.wires[0].ground.distance, 11);
  int next = 1;
  for (const Hazards& at : states)
    for (const Encroachment& one : at.clearances)
      EXPECT_EQ(one.id, next++);
  EXPECT_GT(next, 4);
  settings.conductor.clear();
  EXPECT_THROW(check(settings), std::invalid_argument);
}

} // namespace
