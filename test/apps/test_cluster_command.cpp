// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <string>

#include <linelet/io/point_file.h>

#include "run_tool.h"

namespace linelet::test {
namespace {

class ClusterCommand : public ToolTest {
protected:
  /** \brief 10 x 10 x 4 points one unit apart, in two classes, with a measure. */
  std::string
  cloud() const
  {
    io::Cloud cloud;
    std::vector<std::uint8_t> classes;
    std::vector<float> measure;
    for (int x = 0; x < 10; ++x)
      for (int y = 0; y < 10; ++y)
        for (int z = 0; z < 4; ++z) {
          cloud.points.emplace_back(x + 0.5, y + 0.5, z + 0.5);
          classes.push_back(x % 3 == 0 ? 6 : 2);
          measure.push_back(static_cast<float>(x));
        }
    cloud.set({"classification", classes, {}});
    cloud.set({"measure", measure, {}});
    io::writeCloud(path("in.ply"), cloud);
    return path("in.ply");
  }

  static double
  sum(const io::Cloud& cloud, const char* column)
  {
    double sum = 0;
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      sum += io::valueAt(*cloud.find(column), i);
    return sum;
  }
};

TEST_F(ClusterCommand, ThinsToMeansCountsAndMostFrequentClasses)
{
  runWell("cluster " + cloud() + " " + path("out.ply") +
          " --cells 2,5,1 --moves 0 --json " + path("out.json"));
  const io::Cloud out = io::readCloud(path("out.ply"));
  ASSERT_EQ(out.points.size(), 10u);
  EXPECT_EQ(sum(out, "count"), 400);
  for (std::size_t i = 0; i < out.points.size(); ++i) {
    const Point at = out.points[i] + out.shift;
    EXPECT_NEAR(at.z(), 2, 1e-4);
    EXPECT_NEAR(io::valueAt(*out.find("measure"), i), at.x() - 0.5, 1e-4);
    EXPECT_EQ(io::valueAt(*out.find("classification"), i), 2);
    EXPECT_GT(io::valueAt(*out.find("planarity"), i), 0);
  }
  EXPECT_EQ(json(path("out.json")).at("representatives"), 10);
  EXPECT_EQ(json(path("out.json")).at("clustered"), 400);
}

TEST_F(ClusterCommand, TakesAnEdgeANumberAFieldOrACamera)
{
  const std::string in = cloud(), out = path("out.ply");
  runWell("cluster " + in + " " + out + " --leaf 2.5");
  EXPECT_EQ(sum(io::readCloud(out), "count"), 400);
  runWell("cluster " + in + " " + out + " --count 50");
  EXPECT_EQ(sum(io::readCloud(out), "count"), 400);
  runWell("cluster " + in + " " + out + " --leaf 2.5 --field measure --moves 3");
  EXPECT_EQ(sum(io::readCloud(out), "count"), 400);
  const std::string camera = write("camera.json",
                                   R"({"eye": [-20, 5, 2], "target": [0, 5, 2],
                                       "field_of_view": 30, "width": 800})");
  const Outcome outcome =
      runWell("cluster " + in + " " + out + " --cells 8,8,4 --camera " + camera);
  EXPECT_NE(outcome.out.find("8 x 8 x 4"), std::string::npos) << outcome.out;
  EXPECT_EQ(sum(io::readCloud(out), "count"), 400);
}

TEST_F(ClusterCommand, GivesTheSameFileWithAnyThreadsAndDevice)
{
  const std::string in = cloud();
  runWell("cluster " + in + " " + path("one.ply") + " --leaf 1.7 --threads 1");
  runWell("cluster " + in + " " + path("many.ply") + " --leaf 1.7 --threads 3");
  EXPECT_EQ(contents(path("one.ply")), contents(path("many.ply")));
  const Outcome device =
      run("cluster " + in + " " + path("device.ply") + " --leaf 1.7 --device auto");
  if (device.code == 0) { // OpenCL has a device
    EXPECT_EQ(contents(path("one.ply")), contents(path("device.ply")));
  }
}

TEST_F(ClusterCommand, WritesTheFacesOfItsCellsAsAMesh)
{
  // Cells of 2 x 2 x 4 over a box of 9 x 9 x 3: 5 x 5 of them side by side.
  const std::string start = "cluster " + cloud() + " " + path("out.ply") +
                            " --cells 5,5,1 --moves 0 --json " + path("out.json") +
                            " --mesh " + path("mesh.ply");
  runWell(start + " --faces boxes");
  EXPECT_EQ(json(path("out.json")).at("faces"), 2 * 25 + 4 * 5);
  EXPECT_NE(contents(path("mesh.ply")).find("element face 70\n"), std::string::npos);
  EXPECT_NE(contents(path("mesh.ply")).find("element vertex 72\n"), std::string::npos)
      << "shared corners are one vertex";
  runWell(start); // quads: one plane each
  EXPECT_EQ(json(path("out.json")).at("faces"), 25);
}

TEST_F(ClusterCommand, ReportsErrorsInOneLine)
{
  const std::string in = cloud(), start = "cluster " + in + " " + path("out.ply");
  expectOneLineOf(start, "grid");
  expectOneLineOf(start + " --leaf -1", "-1");
  expectOneLineOf(start + " --leaf 1 --count 5", "more than one grid");
  expectOneLineOf(start + " --leaf 1 --field nothing", "nothing");
  expectOneLineOf(start + " --leaf 1e-9", "cells");
  expectOneLineOf(start + " --cells 4,4,4 --camera " +
                      write("bad.json", "{\"eye\": 3}"),
                  "bad.json");
  expectOneLineOf("cluster " + in + " " + in + " --leaf 1", "in.ply");
  expectOneLineOf(start + " --leaf 1 --faces boxes", "--mesh");
  expectOneLineOf(start + " --leaf 1 --mesh " + path("mesh.obj"), "mesh.obj");
  expectOneLineOf(start + " --leaf 1 --mesh " + in, "in.ply");
  EXPECT_FALSE(std::filesystem::exists(path("out.ply")));
}

} // namespace
} // namespace linelet::test
