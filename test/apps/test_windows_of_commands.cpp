// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// --bounds, --bounds-3d and --resolution of every command that reads points, compared
// with the same command on a file of just those points; virtual point clouds as GDAL
// reads them.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <linelet/io/file_summary.h>
#include <linelet/io/point_file.h>

#include "run_tool.h"
#include "test_data.h"

using namespace linelet;

namespace {

using linelet::test::Outcome;
using linelet::test::ToolTest;

class WindowsOfCommands : public ToolTest {
protected:
  /** \brief Ground and two wires over it, 60 by 30 by 12 m, at whole centimeters. */
  WindowsOfCommands()
  {
    boost::random::mt19937 random(11);
    boost::random::uniform_real_distribution<double> uniform;
    boost::random::normal_distribution<double> normal;
    cloud_.shift = Point(512000, 5427000, 200);
    std::vector<std::uint8_t> classes;
    for (int i = 0; i < 6000; ++i) {
      const double a = 60 * uniform(random);
      const bool wire = i % 3 == 0;
      const Point place =
          wire ? Point(a, (i % 2 == 0 ? 10 : 20) + 0.02 * normal(random), 11)
               : Point(a, 30 * uniform(random), 0.03 * normal(random));
      cloud_.points.emplace_back((place * 100).array().round() / 100);
      classes.push_back(wire ? 14 : 2);
    }
    cloud_.set({"classification", classes, ""});
  }

  /** \brief The points inside, border included. */
  std::size_t
  countIn(double from_x, double to_x, double from_z = -1e9, double to_z = 1e9) const
  {
    std::size_t count = 0;
    for (const Point& p : cloud_.points)
      count += p.x() >= from_x - 1e-6 && p.x() <= to_x + 1e-6 && p.z() >= from_z &&
                       p.z() <= to_z
                   ? 1
                   : 0;
    return count;
  }

  std::size_t
  pointsOf(const std::string& arguments) const
  {
    runWell(arguments + " --json " + path("summary.json"));
    return json(path("summary.json"))["points"].get<std::size_t>();
  }

  io::Cloud cloud_;
};

constexpr const char* bounds = " --bounds 512010,5426000,512040.005,5428000";
constexpr const char* above = " --bounds-3d 512010,5426000,205,512040.005,5428000,300";

} // namespace

TEST_F(WindowsOfCommands, HoldForEveryFormat)
{
  const std::size_t in_plan = countIn(10, 40), wires = countIn(10, 40, 5);
  ASSERT_GT(wires, 500U);
  ASSERT_GT(in_plan, wires + 500);
  for (const char* ending : {".las", ".laz", ".pcd", ".ply", ".xyz", ".csv", ".h5"}) {
    SCOPED_TRACE(ending);
    const std::string file = path(std::string("cloud") + ending);
    try {
      io::writeCloud(file, cloud_);
    }
    catch (const io::FileError& error) {
      EXPECT_STREQ(ending, ".h5") << error.what(); // left out of the build
      continue;
    }
    EXPECT_EQ(pointsOf("info " + file), cloud_.points.size());
    EXPECT_EQ(pointsOf("info " + file + bounds), in_plan);
    EXPECT_EQ(pointsOf("info " + file + above), wires);
    EXPECT_EQ(pointsOf("info " + file + bounds + above), wires);
    EXPECT_EQ(pointsOf("info " + file + " --bounds 0,0,1,1"), 0U);
    const Outcome outcome = runWell("info " + file + " --resolution 5");
    EXPECT_NE(outcome.error.find("it is not a COPC file; --resolution has no effect"),
              std::string::npos)
        << outcome.error;
  }
}

TEST_F(WindowsOfCommands, AreThoseOfAFileOfThePointsInThem)
{
  io::writeCloud(path("cloud.laz"), cloud_);
  runWell("convert " + path("cloud.laz") + " " + path("part.laz") + above);
  ASSERT_EQ(io::summaryOf(path("part.laz")).points, countIn(10, 40, 5));
  for (const auto& [command, output] : std::vector<std::pair<std::string, std::string>>{
           {"info", ""},
           {"convert", "out.las"},
           {"tensor --radius 1", "out.las"},
           {"multiscale", "out.las"},
           {"curves", "out.obj"},
           {"powerlines --overwrite", "wires"},
           {"image --color height", "out.png"},
           {"cluster --leaf 1", "out.las"}}) {
    SCOPED_TRACE(command);
    const std::string to = output.empty() ? "" : " " + path(output);
    runWell(command + " " + path("cloud.laz") + above + to + " --json " +
            path("window.json"));
    runWell(command + " " + path("part.laz") + to + " --json " + path("part.json"));
    const auto window = json(path("window.json")), part = json(path("part.json"));
    EXPECT_EQ(window["points"], countIn(10, 40, 5));
    // Only what does not depend on the origin of the coordinates, which differs between
    // the files.
    for (const char* key :
         {"points", "bounds", "attributes", "classes", "curves", "wires", "spans"})
      EXPECT_EQ(window.value(key, nlohmann::json()), part.value(key, nlohmann::json()))
          << key;
  }
}

TEST_F(WindowsOfCommands, ReadTheLevelsOfCopcThatADistanceNeeds)
{
  LINELET_NEEDS_DATA("readers/copc/silvimetric_test_data_2.copc.laz");
  const std::string file =
      linelet::test::dataPath("readers/copc/silvimetric_test_data_2.copc.laz").string();
  const std::size_t all = pointsOf("info " + file);
  std::size_t before = 0;
  for (const char* distance : {"1000", "10", "0"}) {
    const std::string coarse = file + " --resolution " + distance;
    const std::size_t count = pointsOf("info " + coarse);
    EXPECT_GE(count, before) << distance;
    EXPECT_EQ(pointsOf("convert " + coarse + " " + path("out.las")), count);
    EXPECT_EQ(io::summaryOf(path("out.las")).points, count);
    EXPECT_EQ(pointsOf("image --color height " + coarse + " " + path("out.png")),
              count);
    EXPECT_EQ(pointsOf("cluster --leaf 20 " + coarse + " " + path("out.las")), count);
    before = count;
  }
  EXPECT_EQ(before, all);
  EXPECT_LT(pointsOf("info " + file + " --resolution 1000"), all);
}

TEST_F(WindowsOfCommands, AreRefusedWhereTheyBoundNothing)
{
  io::writeCloud(path("cloud.laz"), cloud_);
  expectOneLineOf("info " + path("cloud.laz") + " --bounds 1,2,3", "X0,Y0,X1,Y1");
  expectOneLineOf("info " + path("cloud.laz") + " --bounds 2,2,1,3", "is empty in");
  expectOneLineOf("info " + path("cloud.laz") + " --resolution -1", "--resolution");
}

TEST_F(WindowsOfCommands, WarnThatTheyDoNotAffectHeaders)
{
  io::writeCloud(path("cloud.laz"), cloud_);
  io::writeCloud(path("more.laz"), cloud_);
  const std::string both = path("cloud.laz") + " " + path("more.laz");
  for (const std::string& command :
       {"info " + both, "vpc " + both + " " + path("out.vpc")}) {
    EXPECT_EQ(runWell(command).error.find("--bounds"), std::string::npos);
    EXPECT_NE(runWell(command + bounds).error.find("have no effect"),
              std::string::npos);
  }
}

TEST_F(WindowsOfCommands, GdalReadsTheFeaturesOfAVirtualPointCloud)
{
  if (std::system("ogrinfo --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "there is no ogrinfo; Debian has it in gdal-bin";
  io::writeCloud(path("a.laz"), cloud_);
  cloud_.shift.x() += 1000;
  cloud_.points.resize(500);
  io::Column* classes = cloud_.find("classification");
  std::get<std::vector<std::uint8_t>>(classes->values).resize(500);
  io::writeCloud(path("b.laz"), cloud_);
  runWell("vpc --crs EPSG:25832 " + path("a.laz") + " " + path("b.laz") + " " +
          path("both.vpc"));
  ASSERT_EQ(std::system(("ogrinfo -ro -al GeoJSON:" + path("both.vpc") + " > " +
                         path("ogrinfo.txt") + " 2>&1")
                            .c_str()),
            0)
      << contents(path("ogrinfo.txt"));
  const std::string text = contents(path("ogrinfo.txt"));
  for (const char* expected : {"using driver `GeoJSON'",
                               "Feature Count: 2",
                               "Geometry: Polygon",
                               "\"WGS 84\"",
                               "pc:count (Integer) = 6000",
                               "pc:count (Integer) = 500",
                               "id (String) = a",
                               "id (String) = b"})
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "\n" << text;
  // Near 48.99 degrees north, 9.16 east: the location in the given reference system.
  const std::size_t at = text.find("Extent: (");
  ASSERT_NE(at, std::string::npos) << text;
  double west = 0, south = 0, east = 0, north = 0;
  ASSERT_EQ(std::sscanf(text.c_str() + at,
                        "Extent: (%lf, %lf) - (%lf, %lf)",
                        &west,
                        &south,
                        &east,
                        &north),
            4);
  EXPECT_NEAR(west, 9.164, 0.005);
  EXPECT_NEAR(south, 48.995, 0.01);
  EXPECT_NEAR(east - west, 1060 / 73000.0, 1e-4);
  EXPECT_LT(north - south, 0.001);
}
