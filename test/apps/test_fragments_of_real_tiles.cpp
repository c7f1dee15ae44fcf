// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// A real forest in two tiles: the result shows no trace of the fragments' borders.

#include <filesystem>
#include <random>
#include <string>

#include "random_seed.h"
#include "run_tool.h"
#include "test_data.h"

namespace linelet::test {

class RealTilesInFragments : public ToolTest {
protected:
  /** The surroundings of the border between two tiles, as two files. */
  void
  SetUp() override
  {
    LINELET_NEEDS_DATA("lidar/bcts/bcts_2.laz");
    std::filesystem::create_directories(path("tiles"));
    for (const std::string name : {"bcts_2.laz", "bcts_3.laz"})
      runWell("convert " + dataPath("lidar/bcts/" + name).string() + " " +
              path("tiles/" + name) + " --bounds 885060,629650,885180,629750");
  }

  /** Writes the same output in one piece and in fragments of random size. */
  void
  compare(const std::string& command, const std::string& ending)
  {
    std::mt19937 random(randomSeed());
    const std::string chunk =
        std::to_string(std::uniform_real_distribution<double>(25, 70)(random));
    SCOPED_TRACE("chunk " + chunk);
    const std::string whole = path("whole" + ending), parts = path("parts" + ending);
    runWell(command + path("tiles") + " " + whole);
    runWell(command + path("tiles") + " " + parts + " --chunk " + chunk + " --json " +
            path("parts.json"));
    EXPECT_GT(json(path("parts.json"))["fragments"], 1);
    if (!ending.empty()) {
      EXPECT_TRUE(contents(whole) == contents(parts));
      return;
    }
    for (const std::string name : {"bcts_2.laz", "bcts_3.laz"})
      EXPECT_TRUE(contents(whole + "/" + name) == contents(parts + "/" + name)) << name;
  }
};

TEST_F(RealTilesInFragments, TensorsAreThoseOfTheWhole)
{
  compare("tensor --radius 1 ", "");
}

TEST_F(RealTilesInFragments, CurvesAreThoseOfTheWhole)
{
  compare("curves ", ".obj");
}

} // namespace linelet::test
