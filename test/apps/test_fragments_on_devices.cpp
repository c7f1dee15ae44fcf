// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Fragments on the processor and two unequal OpenCL devices at once, under every
// heuristic: each point once, with the values that the processor alone gives.

#include <cmath>
#include <cstdlib>

#include <linelet/io/point_file.h>

#include "tiles_test.h"

namespace linelet::test {

class FragmentsOnDevicesTest : public TilesTest {
protected:
  void
  SetUp() override
  {
    // PoCL's drivers for one core and for all.
    ::setenv("POCL_DEVICES", "basic pthread", 1);
    runWell("devices --json " + path("devices.json"));
    devices_ = json(path("devices.json"))["devices"].size();
    if (devices_ < 2)
      GTEST_SKIP() << "OpenCL has " << devices_ << " devices";
    TilesTest::SetUp();
    runWell("tensor --radius 1.5 --engine grid " + path("tiles") + " " + path("a"));
  }

  /** Whether the tile \a name in \a folder has the same neighbors as the processor's,
   * and shape factors as close as doc/cluster.md promises. */
  void
  expectSameTile(const std::string& folder, const std::string& name) const
  {
    const io::Cloud a = io::readCloud(path("a") + "/" + name),
                    b = io::readCloud(folder + "/" + name);
    ASSERT_EQ(a.points.size(), b.points.size());
    EXPECT_TRUE(a.points == b.points) << "different order";
    ASSERT_EQ(a.columns.size(), b.columns.size());
    for (const char* factor : {"linearity", "planarity", "sphericity"}) {
      const io::Column *one = a.find(factor), *other = b.find(factor);
      ASSERT_TRUE(one != nullptr && other != nullptr) << factor;
      double most = 0;
      for (std::size_t i = 0; i < a.points.size(); ++i) {
        const double x = io::valueAt(*one, i), y = io::valueAt(*other, i);
        ASSERT_EQ(std::isnan(x), std::isnan(y)) << name << ", point " << i;
        if (!std::isnan(x))
          most = std::max(most, std::abs(x - y));
      }
      EXPECT_LT(most, 1e-4) << name << ", " << factor;
    }
    for (const char* same : {"neighbors", "classification", "intensity"}) {
      const io::Column *one = a.find(same), *other = b.find(same);
      ASSERT_TRUE(one != nullptr && other != nullptr) << same;
      EXPECT_TRUE(one->values == other->values) << name << ", " << same;
    }
  }

  std::size_t devices_ = 0;
};

TEST_F(FragmentsOnDevicesTest, AreThoseOfTheProcessor)
{
  for (const std::string heuristic :
       {"min-min", "max-min", "sufferage", "simple-h", "simple-hs"}) {
    SCOPED_TRACE(heuristic);
    const std::string folder = path("b_" + heuristic);
    runWell("tensor --radius 1.5 --engine all --chunk 40 --schedule " + heuristic +
            " " + path("tiles") + " " + folder + " --json " + path("b.json"));
    for (int i = 0; i < 4; ++i)
      expectSameTile(folder, "t" + std::to_string(i) + ".laz");
    const nlohmann::json summary = json(path("b.json"));
    std::size_t fragments = 0;
    double points = 0;
    for (const nlohmann::json& device : summary["devices"]) {
      fragments += device["fragments"].get<std::size_t>();
      points += device["points"].get<double>();
    }
    EXPECT_LE(summary["devices"].size(), devices_ + 1);
    EXPECT_EQ(fragments, summary["fragments"].get<std::size_t>());
    EXPECT_EQ(points,
              summary["points"].get<double>() - summary["left_out"].get<double>());
    EXPECT_FALSE(fs::exists(folder + ".fragments")) << "nothing must remain";
  }
}

// Without --chunk there are several fragments for each device; work and merge do the
// same.
TEST_F(FragmentsOnDevicesTest, WorkersUseTheDevicesOfTheirMachine)
{
  runWell("plan tensor --radius 1.5 --engine all " + path("tiles") + " " + path("b"));
  runWell("work " + path("b") + " --every 1/2");
  runWell("work " + path("b") + " --every 2/2");
  runWell("status " + path("b") + " --json " + path("s.json"));
  EXPECT_GE(json(path("s.json"))["done"], devices_ + 1);
  EXPECT_EQ(json(path("s.json"))["left"], 0);
  runWell("merge " + path("b"));
  for (int i = 0; i < 4; ++i)
    expectSameTile(path("b"), "t" + std::to_string(i) + ".laz");
}

// A device that fails leaves its work to the others.
TEST_F(FragmentsOnDevicesTest, ADeviceThatFailsIsLeftOut)
{
  const std::string job = "tensor --radius 1.5 --centroid weighted-median --engine ";
  runWell(job + "grid " + path("tiles") + " " + path("c"));
  const Outcome outcome =
      runWell(job + "all --chunk 60 " + path("tiles") + " " + path("b"));
  EXPECT_NE(outcome.error.find("left out"), std::string::npos) << outcome.error;
  EXPECT_TRUE(folderContents(path("b")) == folderContents(path("c")));
}

} // namespace linelet::test
