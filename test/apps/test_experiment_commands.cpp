// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Experiments with the tool: the user's own geometries, sweeps over settings,
// fourth-order tensors, and vector pictures.

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <gmock/gmock.h>

#include <linelet/features/fourth_order.h>
#include <linelet/io/point_file.h>

#include "run_tool.h"

using namespace linelet;

namespace {

using linelet::test::ToolTest;
using testing::HasSubstr;

class ExperimentCommands : public ToolTest {
protected:
  /** \brief The numbers of all groups of \a pattern in the file \a name. */
  std::vector<std::vector<double>>
  numbersIn(const std::string& name, const std::string& pattern) const
  {
    const std::string text = contents(path(name));
    const std::regex expression(pattern);
    std::vector<std::vector<double>> result;
    for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end;
         ++it) {
      result.emplace_back();
      for (std::size_t k = 1; k < it->size(); ++k)
        result.back().push_back(std::stod((*it)[k]));
    }
    return result;
  }
};

} // namespace

TEST_F(ExperimentCommands, AnyCurvesAreSampledAndDisturbed)
{
  const std::string own = write("own.obj",
                                "v 10 0 0\nv 20 0 0\nv 20 10 0\nv 0 50 5\nv 0 60 5\n"
                                "l 1 2 3\nl 4 5\n");
  runWell("generate " + own + " " + path("own.xyz") + " --points 300 --jitter 0.25 " +
          "--seed 3 --truth " + path("truth.obj") + " --json " + path("own.json"));
  EXPECT_EQ(json(path("own.json"))["length"], 30);
  const io::Cloud cloud = io::readCloud(path("own.xyz"));
  ASSERT_EQ(cloud.points.size(), 300u);
  std::size_t on_first = 0;
  for (const Point& p : cloud.points) {
    const Point world = cloud.shift + p;
    const auto distance = [&](const Point& a, const Point& b) {
      const double t =
          std::clamp((world - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      return (a + t * (b - a) - world).norm();
    };
    const double first =
        std::min(distance({10, 0, 0}, {20, 0, 0}), distance({20, 0, 0}, {20, 10, 0}));
    EXPECT_LE(std::min(first, distance({0, 50, 5}, {0, 60, 5})), 0.2501);
    on_first += first < 1 ? 1 : 0;
  }
  EXPECT_EQ(on_first, 200u) << "by length";
  EXPECT_THAT(runWell("evaluate " + path("truth.obj") + " " + own).out,
              HasSubstr("\nsuccess\n"));
  EXPECT_EQ(run("generate ovals " + path("o.xyz")).code, 2);
  expectOneLineOf("generate " + path("none.obj") + " " + path("o.xyz"), "none.obj");
  expectOneLineOf("generate " + own + " " + own, "own.obj"); // it is an input
}

TEST_F(ExperimentCommands, ASweepRunsEveryCombinationOnce)
{
  const std::string sweep =
      "benchmark --geometries circle --sample 2 --preset published-quick "
      "--vary 'weight=const|fermi-dirac:0.6,0.1' --vary points=40,60 --vary "
      "jitter=0,0.1 --out " +
      path("rows.csv") + " --json ";
  runWell(sweep + path("first.json"));
  const auto result = json(path("first.json"))["combinations"];
  ASSERT_EQ(result.size(), 8u);
  EXPECT_EQ(result[0]["values"], "weight const points 40 jitter 0");
  EXPECT_EQ(result[7]["values"], "weight fermi-dirac:0.6;0.1 points 60 jitter 0.1");
  const std::string rows = contents(path("rows.csv"));
  // A second run finds all rows done and says the same, to the digits of the file.
  const auto expectSame = [](const nlohmann::json& x, const nlohmann::json& y) {
    for (const char* name : {"index", "values", "runs", "success"})
      EXPECT_EQ(x[name], y[name]);
    EXPECT_NEAR(x["e_v"].get<double>(), y["e_v"].get<double>(), 1e-5);
    EXPECT_NEAR(x["e_h"].get<double>(), y["e_h"].get<double>(), 1e-5);
  };
  runWell(sweep + path("second.json"));
  EXPECT_EQ(contents(path("rows.csv")), rows);
  const auto again = json(path("second.json"))["combinations"];
  ASSERT_EQ(again.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i)
    expectSame(again[i], result[i]);
  // A single one, as another machine would run it.
  runWell(sweep + path("one.json") + " --vary-index 5");
  ASSERT_EQ(json(path("one.json"))["combinations"].size(), 1u);
  expectSame(json(path("one.json"))["combinations"][0], result[4]);
  expectOneLineOf("benchmark --vary wait=1", "there is no option 'wait'");
  expectOneLineOf("benchmark --vary weight", "NAME=VALUE");
  expectOneLineOf("benchmark --vary weight=soft", "unknown weighting 'soft'");
  expectOneLineOf("benchmark --vary step=1 --vary-index 9", "--vary-index 9");
}

TEST_F(ExperimentCommands, DistancesAreDrawnAsBoxes)
{
  runWell("benchmark --geometries circle,line --sample 12 --box-plot " +
          path("boxes.png") + " --plot " + path("bars.png"));
  for (const char* picture : {"boxes.png", "bars.png"})
    EXPECT_GT(contents(path(picture)).size(), 10000u) << picture;
  EXPECT_NE(contents(path("boxes.png")), contents(path("bars.png")));
}

TEST_F(ExperimentCommands, TheFourthOrderTensorIsWritten)
{
  runWell("generate helix " + path("helix.ply") + " --points 60 --jitter 0.1");
  runWell("multiscale " + path("helix.ply") + " " + path("out.ply") +
          " --radii 1,2,3 --fourth-order uniform");
  const io::Cloud cloud = io::readCloud(path("out.ply"));
  MultiScaleSettings settings;
  settings.radii = {1, 2, 3};
  const io::Cloud input = io::readCloud(path("helix.ply"));
  const auto tensors =
      fourthOrderTensors(input.points, input.points, settings, ScaleWeight::Uniform);
  for (std::size_t i = 0; i < tensors.size(); ++i) {
    const auto at = [&](const char* name) { return io::valueAt(*cloud.find(name), i); };
    EXPECT_NEAR(at("t4_xx_xx"), tensors[i](0, 0, 0, 0), 1e-5);
    EXPECT_NEAR(at("t4_yy_zz"), tensors[i](1, 1, 2, 2), 1e-5);
    EXPECT_NEAR(at("t4_xy_xy"), 2 * tensors[i](0, 1, 0, 1), 1e-5);
    EXPECT_NEAR(at("major_yz"), tensors[i].eigenTensors().major()(1, 2), 1e-5);
  }
}

TEST_F(ExperimentCommands, LinesFromAboveAreAMapOfTheirCoordinates)
{
  const std::string points = write("points.xyz", "0 0 0\n100 50 7\n30 10 2\n");
  const std::string curve =
      write("curve.obj", "v 0 0 0\nv 100 0 30\nv 100 50 -9\nl 1 2 3\n");
  runWell("image " + points + " " + path("map.svg") +
          " --elevation 90 --color gray --width 624 --height 424 --curves " + curve);
  // 100 x 50 on 624 x 424 pixels with borders of 24: 5.76 pixels per unit.
  const auto path_numbers = numbersIn(
      "map.svg",
      "class=\"curve\" d=\"M([0-9.]+) ([0-9.]+) L([0-9.]+) ([0-9.]+) L([0-9.]+) "
      "([0-9.]+)\"");
  ASSERT_EQ(path_numbers.size(), 1u);
  const std::vector<double>& p = path_numbers[0];
  EXPECT_NEAR(p[2] - p[0], 576, 0.02);
  EXPECT_NEAR(p[3] - p[1], 0, 0.02) << "east is right, whatever the height";
  EXPECT_NEAR(p[4] - p[2], 0, 0.02);
  EXPECT_NEAR(p[5] - p[3], -288, 0.02) << "north is up";
  EXPECT_EQ(numbersIn("map.svg", "<circle cx=\"([0-9.]+)\"").size(), 3u);
}

TEST_F(ExperimentCommands, NearCurvesAreWiderInPerspective)
{
  // Seen from the south: the front line is nearer than the one behind.
  const std::string points = write("points.xyz", "0 0 0\n100 100 0\n");
  const std::string curves =
      write("curves.obj", "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 100 100 0\nl 1 2\nl 3 4\n");
  runWell("image " + points + " " + path("view.svg") +
          " --azimuth 180 --elevation 20 --color gray --curve-width 10 --curves " +
          curves);
  const auto bands = numbersIn("view.svg",
                               "class=\"curve\" d=\"M([0-9.]+) ([0-9.]+) L([0-9.]+) "
                               "([0-9.]+) L([0-9.]+) ([0-9.]+) L([0-9.]+) ([0-9.]+) Z");
  ASSERT_EQ(bands.size(), 2u);
  const auto width = [](const std::vector<double>& b) {
    return std::hypot(b[6] - b[0], b[7] - b[1]);
  };
  const auto length = [](const std::vector<double>& b) {
    return std::hypot(b[2] - b[0], b[3] - b[1]);
  };
  // Far curves are drawn first, so that near ones cover them.
  EXPECT_GT(width(bands[1]), 1.2 * width(bands[0]));
  EXPECT_NEAR(
      width(bands[1]) / length(bands[1]), width(bands[0]) / length(bands[0]), 0.005)
      << "both shrink alike";
}

TEST_F(ExperimentCommands, EllipsesLieAlongALine)
{
  std::string text;
  for (int i = 0; i < 100; ++i)
    text += std::to_string(0.1 * i) + " " + std::to_string(0.1 * i) + " 0\n";
  write("line.xyz", text);
  runWell("image " + path("line.xyz") + " " + path("line.svg") +
          " --fourth-order --elevation 90 --radii 1,2");
  const auto ellipses = numbersIn(
      "line.svg", "rx=\"([0-9.]+)\" ry=\"([0-9.]+)\" transform=\"rotate\\(([-0-9.]+) ");
  ASSERT_EQ(ellipses.size(), 100u);
  for (const std::vector<double>& e : ellipses) {
    EXPECT_GT(e[0], 50 * (e[1] + 0.01));
    // Up to the right is -45 degrees on paper, whose y axis points down.
    EXPECT_NEAR(std::abs(std::tan(e[2] * M_PI / 180) + 1), 0, 0.01);
  }
  expectOneLineOf("image " + path("line.xyz") + " " + path("line.png") +
                      " --fourth-order",
                  "line.png");
  expectOneLineOf("image " + path("line.xyz") + " " + path("a.svg") + " --point 1,1,0",
                  "a.svg");
}

TEST_F(ExperimentCommands, AProfileRunsOverThePointsOfTheFile)
{
  runWell("generate circle " + path("circle.xyz") + " --points 500 --jitter 0.1");
  for (const std::string columns : {"50", "2000"})
    runWell("image " + path("circle.xyz") + " " + path("profile" + columns + ".png") +
            " --by-index --width 500 --height 300 --columns " + columns);
  EXPECT_NE(contents(path("profile50.png")), contents(path("profile2000.png")));
}
