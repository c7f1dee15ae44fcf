// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include <linelet/io/vector_file.h>

#include "run_tool.h"

using namespace linelet;
using linelet::test::Outcome;
using linelet::test::ToolTest;
using testing::HasSubstr;
using testing::StartsWith;

namespace {

class CurveCommands : public ToolTest {};

} // namespace

TEST_F(CurveCommands, TheSameSeedGivesTheSameBytes)
{
  const std::string noise =
      " --points 80 --jitter 0.3 --distribution 0.5 --outliers 20";
  runWell("generate wave " + path("a.xyz") + noise + " --seed 7");
  runWell("generate wave " + path("b.xyz") + noise + " --seed 7");
  runWell("generate wave " + path("c.xyz") + noise + " --seed 8");
  EXPECT_EQ(lines(contents(path("a.xyz"))), 100);
  EXPECT_EQ(contents(path("a.xyz")), contents(path("b.xyz")));
  EXPECT_NE(contents(path("a.xyz")), contents(path("c.xyz")));
}

TEST_F(CurveCommands, TheTruthScoresPerfectly)
{
  const std::string truth = path("truth.obj"), result = path("result.json");
  runWell("generate helix " + path("helix.xyz") + " --truth " + truth);
  EXPECT_THAT(runWell("evaluate " + truth + " " + truth + " --json " + result).out,
              HasSubstr("\nsuccess\n"));
  auto measures = json(result);
  EXPECT_LT(measures["e_h"], 1e-9);
  EXPECT_LT(measures["e_v"], 1e-9);
  EXPECT_NEAR(measures["e_len"], 1, 1e-9);
  EXPECT_NEAR(measures["e_com"], 1, 1e-9);
  EXPECT_EQ(measures["success"], true);

  // A helix is not a straight line.
  runWell("generate line " + path("line.xyz") + " --truth " + path("line.obj"));
  EXPECT_THAT(
      runWell("evaluate " + path("line.obj") + " " + truth + " --json " + result).out,
      HasSubstr("\nno success\n"));
  measures = json(result);
  EXPECT_GT(measures["e_h"], 1);
  EXPECT_EQ(measures["success"], false);
}

// A line parallel to the truth at distance 2 has the same error at both vertices.
TEST_F(CurveCommands, ErrorsAtVerticesAreWritten)
{
  std::ofstream(path("truth.obj")) << "v 0 0 0\nv 9 0 0\nl 1 2\n";
  std::ofstream(path("found.obj")) << "v 1 0 2\nv 4 0 2\nl 1 2\n";
  runWell("evaluate " + path("found.obj") + " " + path("truth.obj") +
          " --vertex-errors " + path("errors.csv"));
  EXPECT_EQ(contents(path("errors.csv")),
            "curve,vertex,x,y,z,along,distance,angle\n"
            "1,0,1,0,2,0,2,0\n"
            "1,1,4,0,2,3,2,0\n");
}

TEST_F(CurveCommands, ACleanHelixIsReconstructedByEveryMethod)
{
  const std::string cloud = path("helix.xyz"), truth = path("truth.obj");
  runWell("generate helix " + cloud + " --truth " + truth);
  for (const std::string method : {"refined", "published"}) {
    SCOPED_TRACE(method);
    runWell("curves " + cloud + " " + path("found.obj") + " --preset " + method);
    runWell("evaluate " + path("found.obj") + " " + truth + " --json " +
            path("result.json"));
    const auto measures = json(path("result.json"));
    EXPECT_EQ(measures["success"], true) << measures;
    EXPECT_LT(measures["e_v"], 0.05);
  }
}

TEST_F(CurveCommands, ACircleIsOneClosedCurveInEveryFormat)
{
  const std::string cloud = path("circle.xyz");
  runWell("generate circle " + cloud + " --points 128");
  const std::vector<std::pair<std::string, std::string>> beginnings = {
      {".obj", "#"},
      {".ply", "ply\n"},
      {".vtk", "# vtk DataFile"},
      {".csv", "curve,vertex,x,y,z"},
      {".geojson", "{"},
      {".gpkg", "SQLite format 3"},
      {".dxf", "  0\nSECTION"}};
  for (const auto& [ending, beginning] : beginnings) {
    SCOPED_TRACE(ending);
    const std::string output = path("circle" + ending);
    const std::string told =
        runWell("curves " + cloud + " " + output + " --json " + path("circle.json"))
            .error;
    // Only GeoJSON always has a reference system.
    EXPECT_EQ(told.find("take the coordinates for degrees") != std::string::npos,
              std::string(ending) == ".geojson")
        << told;
    const auto summary = json(path("circle.json"));
    EXPECT_EQ(summary["points"], 128);
    EXPECT_EQ(summary["curves"], 1);
    EXPECT_EQ(summary["closed"], 1);
    EXPECT_NEAR(summary["length"], 31.416, 0.1); // radius 5
    ASSERT_EQ(summary["measures"].size(), 1U);
    const auto& measures = summary["measures"][0];
    EXPECT_EQ(measures["length"], summary["length"]);
    EXPECT_EQ(measures["closed"], true);
    EXPECT_NEAR(measures["density"], 128 / 31.416, 0.2);
    EXPECT_LT(measures["noise"], 0.05);
    EXPECT_GT(measures["evidence"], 100);
    EXPECT_THAT(contents(output), StartsWith(beginning));
  }
  const CurveNetwork network = io::readCurves(path("circle.obj"));
  ASSERT_EQ(network.curves.size(), 1u);
  EXPECT_TRUE(network.curves[0].closed);
  for (const Point& vertex : network.curves[0].points)
    EXPECT_NEAR(vertex.norm(), 5, 0.05);
  EXPECT_EQ(json(path("circle.geojson"))["features"].size(), 1u);
  EXPECT_THAT(contents(path("circle.dxf")), HasSubstr("POLYLINE"));
}

TEST_F(CurveCommands, WithoutCurvesTheOutputIsEmptyButValid)
{
  const std::string empty = write("empty.csv", "x,y,z\n"),
                    one = write("one.csv", "x,y,z\n1,2,3\n"),
                    twice = write("twice.csv", "x,y,z\n1,2,3\n1,2,3\n");
  for (const std::string& call : {empty + " none.obj",
                                  empty + " none.geojson",
                                  one + " none.gpkg",
                                  one + " none.obj --preset published",
                                  twice + " none.geojson --preset published"}) {
    SCOPED_TRACE(call);
    const std::size_t space = call.find(' ');
    const Outcome run =
        runWell("curves " + call.substr(0, space) + " " + path(call.substr(space + 1)));
    EXPECT_EQ(lines(run.error), 1);
    EXPECT_THAT(run.error, HasSubstr("no curve found"));
    EXPECT_THAT(run.out, HasSubstr(" 0 curves"));
  }
  EXPECT_TRUE(io::readCurves(path("none.obj")).curves.empty());
  EXPECT_TRUE(json(path("none.geojson"))["features"].empty());
  EXPECT_THAT(contents(path("none.gpkg")), StartsWith("SQLite format 3"));
}

TEST_F(CurveCommands, TensorsOfAVolumeAreFollowed)
{
  // A straight diffusion along (2, 1, 0) in a block of 12 x 8 x 3 samples.
  std::string volume = "NRRD0005\ntype: float\ndimension: 4\nsizes: 6 12 8 3\n"
                       "kinds: 3D-symmetric-matrix space space space\n"
                       "spacings: nan 1 1 1\nencoding: ascii\n\n";
  for (int i = 0; i < 12 * 8 * 3; ++i)
    volume += "4.2 2 0 1.2 0 0.2\n";
  const std::string in = write("volume.nrrd", volume), out = path("lines.obj");
  const std::string start = "curves " + in + " " + out + " --tensors --start 146 ";
  runWell(start + "--preset published --direction eigenvector --prune-distance 4 "
                  "--simplify 0");
  const CurveNetwork network = io::readCurves(out, Point::Zero());
  ASSERT_EQ(network.curves.size(), 1u);
  EXPECT_GT(length(network), 7);
  for (const Point& p : network.curves[0].points) // through sample 2, 4, 1
    EXPECT_LT(std::hypot(p.y() - 4 - (p.x() - 2) / 2, p.z() - 1), 0.02);
  const Outcome unused = runWell(start);
  EXPECT_NE(unused.error.find("--tensors has no effect"), std::string::npos)
      << unused.error;
  expectOneLineOf("curves " + write("points.csv", "0 0 0\n1 0 0\n2 0 0\n") + " " + out +
                      " --preset published --tensors",
                  "no attribute 'xx'");
}

TEST_F(CurveCommands, OnlyTheChosenClassesAreUsed)
{
  std::string text = "x,y,z,classification\n";
  for (int i = 0; i < 100; ++i)
    text +=
        std::to_string(0.1 * i) + ",0,5,14\n" + std::to_string(0.1 * i) + ",20,0,2\n";
  const std::string cloud = write("scene.csv", text), output = path("wires.obj");
  runWell("curves " + cloud + " " + output + " --keep-classes 14 --json " +
          path("wires.json"));
  EXPECT_EQ(json(path("wires.json"))["points"], 100);
  const CurveNetwork network = io::readCurves(output);
  ASSERT_EQ(network.curves.size(), 1u);
  for (const Point& vertex : network.curves[0].points)
    EXPECT_NEAR(vertex.z(), 5, 1e-3);
  EXPECT_THAT(runWell("curves " + cloud + " " + output + " --keep-classes 99").error,
              HasSubstr("no points are left"));
  runWell("generate circle " + path("circle.xyz"));
  expectOneLineOf("curves " + path("circle.xyz") + " " + path("out.obj") +
                      " --keep-classes 14",
                  "no classes");
}

TEST_F(CurveCommands, ABenchmarkIsDrawn)
{
  runWell("benchmark --sample 20 --seed 3 --plot " + path("success.png"));
  EXPECT_THAT(contents(path("success.png")), StartsWith("\x89PNG"));
}

TEST_F(CurveCommands, ABenchmarkResumesWhereItStopped)
{
  const std::string rows = path("rows.csv");
  const std::string command =
      "benchmark --sample 20 --seed 3 --out " + rows + " --json " + path("runs.json");
  runWell(command);
  EXPECT_EQ(json(path("runs.json"))["runs"], 20);
  EXPECT_EQ(json(path("runs.json"))["resumed"], 0);
  const std::string all = contents(rows);
  EXPECT_EQ(lines(all), 21);
  EXPECT_THAT(all, StartsWith("method,geometry,points,"));

  runWell(command);
  EXPECT_EQ(json(path("runs.json"))["resumed"], 20);
  EXPECT_EQ(contents(rows), all);

  // As if killed while writing the fifth row.
  std::size_t end = 0;
  for (int line = 0; line < 5; ++line)
    end = all.find('\n', end) + 1;
  write("rows.csv", all.substr(0, end + 10));
  runWell(command);
  EXPECT_EQ(json(path("runs.json"))["runs"], 20);
  EXPECT_EQ(json(path("runs.json"))["resumed"], 4);
  EXPECT_EQ(lines(contents(rows)), 21);
}

TEST_F(CurveCommands, RowsOfOtherSettingsAreKeptApart)
{
  const std::string command = "benchmark --sample 10 --seed 3 --out " +
                              path("rows.csv") + " --json " + path("runs.json") +
                              " --preset published";
  runWell(command);
  runWell(command + " --scheme euler");
  EXPECT_EQ(json(path("runs.json"))["resumed"], 0);
  EXPECT_EQ(json(path("runs.json"))["method"], "published scheme euler");
  // The default, named explicitly, changes nothing.
  runWell(command + " --scheme rk32");
  EXPECT_EQ(json(path("runs.json"))["resumed"], 10);
  EXPECT_EQ(json(path("runs.json"))["method"], "published");
  EXPECT_EQ(lines(contents(path("rows.csv"))), 21);
  expectOneLineOf(command + " --label a,b", "--label a,b");
}

TEST_F(CurveCommands, AStraightWireHasFewVertices)
{
  // Five hundred points along a line, with noise of a hundredth.
  std::string text;
  for (int i = 0; i < 500; ++i)
    text += std::to_string(0.1 * i) + " " + std::to_string(0.01 * std::sin(i * 7.1)) +
            " " + std::to_string(0.01 * std::cos(i * 3.7)) + "\n";
  const std::string cloud = write("wire.xyz", text);
  const auto verticesOf = [&](const std::string& options) {
    runWell("curves " + cloud + " " + path("wire.gpkg") + options + " --json " +
            path("wire.json"));
    return json(path("wire.json"))["vertices"].get<int>();
  };
  const int all = verticesOf(" --simplify 0");
  runWell("curves " + cloud + " " + path("all.obj") + " --simplify 0");
  const int few = verticesOf("");
  EXPECT_GT(all, 10);
  EXPECT_LT(few, all / 2);
  const double tolerance = json(path("wire.json"))["simplify_tolerance"];
  EXPECT_NEAR(tolerance, 0.001, 0.0005); // a tenth of the noise
  // It is the same curve to within this tolerance.
  runWell("evaluate " + path("all.obj") + " " + path("wire.gpkg") + " --json " +
          path("same.json"));
  EXPECT_LE(json(path("same.json"))["e_h"].get<double>(), tolerance * 1.01);
  EXPECT_EQ(verticesOf(" --simplify 1"), 2);
  EXPECT_EQ(run("curves " + cloud + " " + path("a.obj") + " --simplify -1").code, 2);
  EXPECT_EQ(run("curves " + cloud + " " + path("a.obj") + " --simplify x").code, 2);
  // A closed curve stays one.
  runWell("generate circle " + path("circle.xyz") + " --points 400");
  runWell("curves " + path("circle.xyz") + " " + path("circle.obj") +
          " --simplify 100 --json " + path("circle.json"));
  EXPECT_EQ(json(path("circle.json"))["closed"], 1);
}
