// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Which points are used by class, and which classes points get.

#include <map>

#include <gmock/gmock.h>

#include <linelet/io/point_file.h>

#include "run_tool.h"

namespace linelet::test {

namespace {

using testing::HasSubstr;

class Classes : public ToolTest {
protected:
  /** \brief A line of class 14 and a line of class 7 above it. */
  std::string
  twoLines() const
  {
    std::string text = "x,y,z,classification\n";
    for (int i = 0; i < 100; ++i)
      for (const int kind : {14, 7})
        text += std::to_string(0.1 * i) + ",0," + (kind == 14 ? "0," : "0.3,") +
                std::to_string(kind) + "\n";
    return write("lines.csv", text);
  }

  static std::map<int, std::size_t>
  countsOf(const std::string& file)
  {
    const io::Cloud cloud = io::readCloud(file);
    const io::Column* classes = cloud.find("classification");
    std::map<int, std::size_t> counts;
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      ++counts[static_cast<int>(io::valueAt(*classes, i))];
    return counts;
  }

  const std::string corridor_ = std::string(LINELET_SOURCE_DIR) + "/data/corridor.las";
};

} // namespace

TEST_F(Classes, NoiseIsLeftOutByDefault)
{
  const std::string cloud = twoLines(), out = path("out.csv");
  const auto neighbors = [&](const std::string& options) {
    runWell("tensor --radius 0.45 " + cloud + " " + out + options + " --json " +
            path("out.json"));
    return json(path("out.json"))["mean_neighbors"].get<double>();
  };
  EXPECT_NEAR(neighbors(""), 8.8, 0.01); // nine, fewer at the ends
  EXPECT_EQ(json(path("out.json"))["ignored"], 100);
  EXPECT_GT(neighbors(" --ignore-classes none"), 15);
  EXPECT_GT(neighbors(" --keep-classes 7,14"), 15);
  EXPECT_NEAR(neighbors(" --keep-classes 7"), 8.8, 0.01);
  EXPECT_NEAR(neighbors(" --ignore-classes 14"), 8.8, 0.01);
  // It stays in the file but has no shape.
  runWell("tensor --radius 0.45 " + cloud + " " + out);
  const io::Cloud shapes = io::readCloud(out);
  ASSERT_EQ(shapes.points.size(), 200u);
  EXPECT_TRUE(std::isnan(io::valueAt(*shapes.find("linearity"), 1)));
  EXPECT_EQ(io::valueAt(*shapes.find("classification"), 1), 7);
  for (const std::string& command : {"curves " + cloud + " " + path("out.obj"),
                                     "multiscale " + cloud + " " + path("out.las"),
                                     "image " + cloud + " " + path("out.png"),
                                     "info " + cloud})
    EXPECT_THAT(runWell(command).error, HasSubstr("are of class 7 and were ignored"))
        << command;
}

TEST_F(Classes, ListsAreChecked)
{
  const std::string cloud = twoLines();
  EXPECT_EQ(run("info " + cloud + " --ignore-classes 7,x").code, 2);
  EXPECT_EQ(run("info " + cloud + " --keep-classes 256").code, 2);
  EXPECT_THAT(run("info " + cloud + " --keep-classes -1").error,
              HasSubstr("is not a list of classes"));
  const std::string bare = write("bare.xyz", "0 0 0\n1 0 0\n");
  expectOneLineOf("info " + bare + " --keep-classes 2", "have no classes");
  runWell("info " + bare + " --ignore-classes 2");
}

TEST_F(Classes, SurviveAnOptionFile)
{
  const std::string cloud = twoLines();
  for (const std::string options :
       {"", "--ignore-classes none", "--keep-classes 7,14"}) {
    const std::string config = runWell("info --print-config " + options).out;
    EXPECT_EQ(
        runWell("info " + cloud + " --config " + write("options.toml", config)).out,
        runWell("info " + cloud + " " + options).out)
        << config;
  }
}

// Points of a noise class near a wire must not become a hazard.
TEST_F(Classes, BirdsUnderAWireAreNotAHazard)
{
  io::Cloud cloud = io::readCloud(corridor_);
  auto& classes =
      std::get<std::vector<std::uint8_t>>(cloud.find("classification")->values);
  // Ground points, which are missing from the ground in both runs, none of them at the
  // border of the cloud, ...
  std::vector<std::size_t> birds;
  for (std::size_t i = cloud.points.size() / 4; birds.size() < 400; ++i)
    if (classes[i] == 2) {
      classes[i] = birds.size() % 2 == 0 ? 18 : 7;
      birds.push_back(i);
    }
  io::writeCloud(path("plain.las"), cloud);
  runWell("powerlines " + path("plain.las") + " " + path("plain"));
  const auto before = json(path("plain/summary.json"))["wires"];
  ASSERT_FALSE(before.empty());
  // ... become a dense patch half a meter below the middle of every wire.
  for (std::size_t k = 0; k < birds.size(); ++k) {
    const auto& wire = before[k % before.size()];
    const auto &front = wire["from"], &back = wire["to"];
    Point middle;
    for (int axis = 0; axis < 3; ++axis)
      middle[axis] = (front[static_cast<std::size_t>(axis)].get<double>() +
                      back[static_cast<std::size_t>(axis)].get<double>()) /
                     2;
    middle.z() -= wire["sag"].get<double>() + 0.5 + 0.01 * static_cast<double>(k);
    cloud.points[birds[k]] = middle - cloud.shift;
  }
  io::writeCloud(path("birds.las"), cloud);
  runWell("powerlines " + path("birds.las") + " " + path("birds"));
  const auto after = json(path("birds/summary.json"))["wires"];
  ASSERT_EQ(after.size(), before.size());
  const auto clearanceOf = [](const nlohmann::json& wire) {
    const auto& clearance = wire["vegetation_clearance"];
    return clearance.is_null() ? 99 : clearance["distance"].get<double>();
  };
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(clearanceOf(after[i]), clearanceOf(before[i]), 0.01) << i;
  // On request they count as obstacles.
  runWell("powerlines --overwrite --ignore-classes none " + path("birds.las") + " " +
          path("birds"));
  const auto asked = json(path("birds/summary.json"))["wires"];
  EXPECT_TRUE(std::any_of(asked.begin(), asked.end(), [&](const auto& wire) {
    return clearanceOf(wire) < 1.5;
  }));
}

// With nothing but the line in the cloud, its clearance is unknown.
TEST_F(Classes, AWireAboveNothingHasNoKnownClearance)
{
  const std::string figures = path("figures.json");
  const auto outputOf = [&](const std::string& cloud) {
    return runWell("powerlines " + cloud + " " + path("out") + " --json " + figures +
                   " --overwrite")
        .out;
  };
  EXPECT_THAT(outputOf(corridor_), HasSubstr("wires below 5.0 m"));
  EXPECT_TRUE(json(figures)["wires_below_clearance"].is_number());
  std::string text = "x,y,z\n";
  for (int i = 0; i < 800; ++i)
    for (const int y : {0, 4}) {
      const double x = 0.25 * i, z = 20 + (x - 100) * (x - 100) / 2000;
      text +=
          std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z) + "\n";
    }
  EXPECT_THAT(outputOf(write("wires.csv", text)),
              HasSubstr("clearance              unknown"));
  EXPECT_EQ(json(figures)["wires"], 2);
  EXPECT_TRUE(json(figures)["wires_below_clearance"].is_null());
  const auto totals = json(path("out/summary.json"))["totals"];
  EXPECT_TRUE(totals["wires_below_clearance"].is_null());
}

TEST_F(Classes, OfPowerLinesAreConfigurable)
{
  const std::string plain = path("plain"), other = path("other");
  runWell("powerlines " + corridor_ + " " + plain + " --existing-classes reset");
  runWell("powerlines " + corridor_ + " " + other +
          " --existing-classes reset --wire-class 20 --tower-class 64");
  auto a = countsOf(plain + "/classified.las"), b = countsOf(other + "/classified.las");
  ASSERT_GT(a[14], 0u);
  ASSERT_GT(a[15], 0u);
  EXPECT_EQ(a[14], b[20]);
  EXPECT_EQ(a[15], b[64]);
  expectOneLineOf("powerlines " + corridor_ + " " + other + " --wire-class 300", "300");
  expectOneLineOf("powerlines " + corridor_ + " " + other + " --wire-class 15",
                  "choose different classes");
}

TEST_F(Classes, OfTheInputAreKeptOrReset)
{
  io::Cloud cloud = io::readCloud(corridor_);
  // A patch of ground misclassified as wire.
  auto& classes =
      std::get<std::vector<std::uint8_t>>(cloud.find("classification")->values);
  std::vector<std::size_t> wrong;
  for (std::size_t i = 0; i < classes.size() && wrong.size() < 500; ++i)
    if (classes[i] == 2) {
      classes[i] = 14;
      wrong.push_back(i);
    }
  io::writeCloud(path("wrong.las"), cloud);
  const auto classOfWrong = [&](const std::string& options) {
    const Outcome outcome = runWell("powerlines " + path("wrong.las") + " " +
                                    path("out") + " --overwrite" + options);
    EXPECT_EQ(outcome.error.find("they keep it") == std::string::npos,
              !options.empty());
    const io::Cloud result = io::readCloud(path("out/classified.las"));
    std::map<int, int> counts;
    for (const std::size_t i : wrong)
      ++counts[static_cast<int>(io::valueAt(*result.find("classification"), i))];
    return counts;
  };
  EXPECT_EQ(classOfWrong("")[14], 500);
  EXPECT_GE(classOfWrong(" --existing-classes reset")[1], 495);
}

} // namespace linelet::test
