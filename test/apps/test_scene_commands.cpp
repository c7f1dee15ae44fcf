// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gmock/gmock.h>

#include <bench/measures/segment_tree.h>
#include <linelet/io/point_file.h>
#include <linelet/io/vector_file.h>

#include "run_tool.h"

using namespace linelet;
using linelet::test::Outcome;
using linelet::test::ToolTest;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

namespace {

class SceneCommands : public ToolTest {
protected:
  /** \brief A wire with a little noise, each point with an id. */
  std::string
  writeWire(int count) const
  {
    boost::random::mt19937 random(5);
    boost::random::normal_distribution<double> normal(0, 0.02);
    std::string text = "x,y,z,id\n";
    for (int i = 0; i < count; ++i)
      text += std::to_string(0.1 * i + normal(random)) + "," +
              std::to_string(normal(random)) + "," + std::to_string(normal(random)) +
              "," + std::to_string(1000 + i) + "\n";
    return write("wire.csv", text);
  }

  /** \brief Checks what every run of `powerlines` leaves behind, with or without wires.
   * \return the summary */
  nlohmann::json
  expectAllFiles(const std::string& folder, std::size_t points) const
  {
    const auto entries = std::filesystem::directory_iterator(folder);
    EXPECT_EQ(std::distance(begin(entries), end(entries)), 12);
    EXPECT_THAT(contents(folder + "/wires.gpkg"), StartsWith("SQLite format 3"));
    EXPECT_THAT(contents(folder + "/wires.dxf"), HasSubstr("\nEOF\n"));
    EXPECT_THAT(contents(folder + "/report.html"), HasSubstr("</html>"));
    const io::Cloud cloud = io::readCloud(folder + "/classified.las");
    EXPECT_EQ(cloud.points.size(), points);
    const nlohmann::json summary = json(folder + "/summary.json");
    EXPECT_EQ(summary["points"], points);

    // All files agree on the number of wires.
    std::size_t drawn = 0;
    const nlohmann::json drawing = json(folder + "/wires.geojson");
    for (const auto& feature : drawing["features"])
      drawn += feature["properties"]["layer"] == "wires" ? 1 : 0;
    EXPECT_EQ(drawn, summary["wires"].size());
    std::size_t wire_points = 0;
    for (std::size_t i = 0; i < points; ++i)
      if (io::valueAt(*cloud.find("wire_id"), i) > 0) {
        EXPECT_EQ(io::valueAt(*cloud.find("classification"), i), 14);
        ++wire_points;
      }
    EXPECT_EQ(wire_points, summary["totals"]["wire_points"]);
    return summary;
  }

  static std::uint32_t
  bigEndian(const std::string& bytes, std::size_t at)
  {
    std::uint32_t number = 0;
    for (std::size_t i = at; i < at + 4; ++i)
      number = number << 8 | static_cast<std::uint8_t>(bytes.at(i));
    return number;
  }
};

} // namespace

TEST_F(SceneCommands, MultiscaleAddsTheOptimalScale)
{
  const std::string input = writeWire(150), output = path("out.las"),
                    graphs = path("graphs.csv");
  runWell("multiscale " + input + " " + output + " --graphs " + graphs + " --json " +
          path("scales.json"));
  const auto summary = json(path("scales.json"));
  EXPECT_EQ(summary["points"], 150);
  EXPECT_EQ(summary["unknown"], 0);
  // The 6th neighbor of a point on the wire is the third to one side.
  EXPECT_NEAR(summary["scale_unit"], 0.3, 0.06);
  EXPECT_GT(summary["noise_rate"], 0);
  EXPECT_LT(summary["noise_rate"], 0.5);
  const auto radii = summary["radii"].get<std::vector<double>>();
  ASSERT_GE(radii.size(), 2u);
  EXPECT_TRUE(std::is_sorted(radii.begin(), radii.end()));

  const std::string table = contents(graphs);
  EXPECT_THAT(table, StartsWith("point,scale,radius,neighbors,linearity,"));
  EXPECT_EQ(lines(table), 1 + 150 * static_cast<std::ptrdiff_t>(radii.size()));

  const io::Cloud before = io::readCloud(input), after = io::readCloud(output);
  ASSERT_EQ(after.points.size(), 150u);
  for (const char* name : {"id", "optimal_radius", "linearity", "major_x", "scale"})
    ASSERT_NE(after.find(name), nullptr) << name;
  for (std::size_t i = 0; i < 150; ++i) {
    EXPECT_EQ(io::valueAt(*after.find("id"), i), io::valueAt(*before.find("id"), i));
    EXPECT_GT(io::valueAt(*after.find("linearity"), i), 0.9);
    EXPECT_GT(std::abs(io::valueAt(*after.find("major_x"), i)), 0.9);
  }
}

TEST_F(SceneCommands, MultiscaleUsesTheGivenRadii)
{
  const std::string call = "multiscale " + writeWire(50) + " " + path("out.csv");
  runWell(call + " --radii 0.5,1,2 --json " + path("scales.json"));
  EXPECT_EQ(json(path("scales.json"))["radii"], (std::vector<double>{0.5, 1, 2}));
  EXPECT_EQ(run(call + " --radii 2,1").code, 1);
  expectOneLineOf("multiscale " + write("one.xyz", "1 2 3\n") + " " + path("one.las"),
                  "give the radii or a scale unit");
}

TEST_F(SceneCommands, PowerlinesFindsTheWiresOfTheSampleScan)
{
  const std::string scan = std::string(LINELET_SOURCE_DIR) + "/data/corridor.las";
  const Outcome run = runWell("powerlines " + scan + " " + path("corridor") +
                              " --json " + path("corridor.json"));
  const auto summary =
      expectAllFiles(path("corridor"), io::readCloud(scan).points.size());
  EXPECT_EQ(summary["source"], "corridor.las");
  // The truth has 33, stubs at the border of the scan included.
  EXPECT_GE(std::count_if(summary["wires"].begin(),
                          summary["wires"].end(),
                          [](const auto& wire) { return wire["confidence"] > 0.5; }),
            30);
  const auto told = json(path("corridor.json"));
  EXPECT_EQ(told["wires"], summary["wires"].size());
  for (const std::string file : told["files"]) {
    EXPECT_TRUE(std::filesystem::exists(file)) << file;
    EXPECT_THAT(run.out, HasSubstr(file + "\n"));
  }
}

TEST_F(SceneCommands, PowerlinesFindsNoneOnBareGround)
{
  boost::random::mt19937 random(2);
  boost::random::uniform_real_distribution<double> place(0, 60);
  boost::random::normal_distribution<double> height(0, 0.03);
  std::string text = "x,y,z\n";
  for (int i = 0; i < 3000; ++i)
    text += std::to_string(place(random)) + "," + std::to_string(place(random)) + "," +
            std::to_string(height(random)) + "\n";
  const std::vector<std::pair<std::string, std::size_t>> clouds = {
      {text, 3000}, {"x,y,z\n", 0}, {"x,y,z\n1,2,3\n", 1}};
  for (const auto& [points, count] : clouds) {
    SCOPED_TRACE(count);
    const std::string folder = path("bare" + std::to_string(count));
    EXPECT_THAT(runWell("powerlines " + write("bare.csv", points) + " " + folder).out,
                HasSubstr("no wires found"));
    EXPECT_TRUE(expectAllFiles(folder, count)["wires"].empty());
  }
}

TEST_F(SceneCommands, AMissingReferenceSystemIsReportedOnce)
{
  const std::string sample = std::string(LINELET_SOURCE_DIR) + "/data/corridor.las";
  io::Cloud cloud = io::readCloud(sample);
  ASSERT_FALSE(cloud.wkt.empty());
  const std::string call = "powerlines --ignore-classes none --existing-classes reset ";
  EXPECT_THAT(runWell(call + sample + " " + path("known")).error,
              Not(HasSubstr("reference system")));

  cloud.wkt.clear();
  io::writeCloud(path("nowhere.las"), cloud);
  const Outcome run = runWell(call + path("nowhere.las") + " " + path("unknown"));
  // Once for what is read, once for the file that cannot do without.
  const std::string said = "no reference system";
  std::size_t times = 0;
  for (std::size_t at = run.error.find(said); at != std::string::npos;
       at = run.error.find(said, at + 1))
    ++times;
  EXPECT_EQ(times, 2) << run.error;
  EXPECT_THAT(run.error, HasSubstr("its coordinates are taken as meters"));
  EXPECT_THAT(run.error, HasSubstr(path("unknown/wires.geojson")));
  EXPECT_THAT(run.error, HasSubstr("take the coordinates for degrees"));
}

TEST_F(SceneCommands, ImagesArePngFilesOfTheWantedSize)
{
  const std::string input = writeWire(100);
  for (const std::string kind :
       {"--kind cloud", "--kind graphs --point 50", "--probe 0,0,0,9,0,0"}) {
    SCOPED_TRACE(kind);
    runWell("image " + input + " " + path("picture.png") +
            " --width 320 --height 240 --max-radius 3 " + kind);
    const std::string picture = contents(path("picture.png"));
    ASSERT_GT(picture.size(), 33u);
    EXPECT_EQ(picture.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(picture.substr(12, 4), "IHDR");
    EXPECT_EQ(bigEndian(picture, 16), 320u);
    EXPECT_EQ(bigEndian(picture, 20), 240u);
  }
  expectOneLineOf("image " + write("none.csv", "x,y,z\n") + " " + path("none.png"),
                  path("none.csv"));
  expectOneLineOf("image " + input + " " + path("none.png") + " --width 5", "width");
  EXPECT_FALSE(std::filesystem::exists(path("none.png")));
}

TEST_F(SceneCommands, GeneratedScenesComeWithTheirTruth)
{
  runWell("generate scene quad " + path("quad.las") + " --seed 2 --density 1 --truth " +
          path("wires.obj") + " --structures " + path("other.obj") + " --json " +
          path("quad.json"));
  const io::Cloud cloud = io::readCloud(path("quad.las"));
  const nlohmann::json told = json(path("quad.json"));
  EXPECT_EQ(told["points"], cloud.points.size());
  EXPECT_EQ(told["scene"], "quad");
  const CurveNetwork wires = io::readCurves(path("wires.obj"), cloud.shift);
  ASSERT_EQ(wires.curves.size(), told["wires"].size());
  EXPECT_NEAR(length(wires), told["wire_length"], 0.1);
  // The files agree on the coordinates: points of wires lie along the truth.
  const bench::SegmentTree tree(wires);
  std::size_t count = 0, near = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (io::valueAt(*cloud.find("classification"), i) == 14) {
      ++count;
      near += tree.nearest(cloud.points[i]).squared_distance < 1 ? 1 : 0;
    }
  EXPECT_GT(count, 1000U);
  EXPECT_GT(static_cast<double>(near), 0.95 * static_cast<double>(count));
  const CurveNetwork other = io::readCurves(path("other.obj"), cloud.shift);
  EXPECT_GT(other.curves.size(), 100U);
  expectOneLineOf("generate scene quad " + path("no.las") + " --noise -1", "noise");
  EXPECT_FALSE(std::filesystem::exists(path("no.las")));
}
