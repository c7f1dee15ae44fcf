// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>

#include "model_test.h"
#include "test_data.h"

namespace {

using namespace linelet;
using namespace linelet::view;

class ViewAndTool : public linelet::test::ModelTest {
protected:
  void
  runTool(const std::string& arguments) const
  {
    const std::string command =
        std::string(LINELET_TOOL) + " " + arguments + " > " + path("out.txt") + " 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }

  std::string
  textOf(const std::string& name) const
  {
    std::ostringstream text;
    text << std::ifstream(path(name)).rdbuf();
    return text.str();
  }

  /** Lines of the graph file about \a point. */
  static std::vector<std::string>
  rowsOf(const std::string& csv, std::size_t point)
  {
    std::vector<std::string> rows;
    std::istringstream in(csv);
    const std::string lead = std::to_string(point) + ",";
    for (std::string line; std::getline(in, line);)
      if (line.compare(0, lead.size(), lead) == 0)
        rows.push_back(line);
    return rows;
  }

  /** The same for the graphs at the selection. */
  std::vector<std::string>
  rowsOfSelection() const
  {
    std::vector<std::string> rows;
    char cell[64];
    for (std::size_t k = 0; k < model.graphs()->graph.size(); ++k) {
      const ScaleShape& s = model.graphs()->graph[k];
      std::snprintf(cell,
                    sizeof cell,
                    "%u,%zu,%.9g,%u",
                    *model.selected(),
                    k,
                    model.graphs()->radii[k],
                    s.neighbors);
      std::string row = cell;
      for (const float value :
           {s.linearity, s.planarity, s.sphericity, s.major_x, s.major_y, s.major_z}) {
        std::snprintf(cell, sizeof cell, ",%.7g", static_cast<double>(value));
        row += std::isnan(value) ? "," : cell;
      }
      rows.push_back(row);
    }
    return rows;
  }

  void
  compareGraphs(const std::string& input, const std::string& options, Index step)
  {
    runTool("multiscale " + options + " " + input + " " + path("out.las") +
            " --graphs " + path("graphs.csv"));
    const std::string csv = textOf("graphs.csv");
    const auto count = static_cast<Index>(model.scene().points.size());
    for (Index i = 0; i < count; i += step) {
      model.select(i);
      model.wait();
      ASSERT_NE(model.graphs(), nullptr);
      EXPECT_EQ(rowsOfSelection(), rowsOf(csv, i)) << i;
    }
  }
};

TEST_F(ViewAndTool, GraphsAreThoseOfTheToolToTheDigit)
{
  const std::string wire = writeWire();
  open(wire);
  compareGraphs(wire, "--engine sweep", 97);
  // Once everything is computed, values are those of that run, by whatever engine.
  model.compute(Analysis::MultiScale);
  EXPECT_EQ(model.wait().error, "");
  EXPECT_TRUE(model.graphs()->stored);
  compareGraphs(wire, "", 97);
}

TEST_F(ViewAndTool, GraphsOfARealTileToTheDigit)
{
  LINELET_NEEDS_DATA("lidar/uav_towers");
  std::filesystem::path tile;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::dataPath("lidar/uav_towers")))
    if (tile.empty() || entry.path() < tile)
      tile = entry.path();
  model.settings.set(Analysis::MultiScale, "max-radius", "2");
  open(tile.string());
  compareGraphs(tile.string(), "--engine sweep --max-radius 2", 997);
  model.compute(Analysis::MultiScale);
  EXPECT_EQ(model.wait().error, "");
  compareGraphs(tile.string(), "--max-radius 2", 997);
}

// What the window shows can be run: the tool reads the file and prints the same
// options.
TEST_F(ViewAndTool, OptionFilesAreTheTools)
{
  model.settings.set(Analysis::MultiScale, "max-radius", "1.25");
  model.settings.set(Analysis::MultiScale, "centroid", "mean");
  model.settings.set(Analysis::Curves, "preset", "published");
  model.settings.set(Analysis::PowerLines, "max-gap", "30");
  model.settings.set(Analysis::Tensor, "weight", "fermi-dirac:0.5,0.2");
  for (const auto& [analysis, name] : Names<Analysis>::table) {
    write("options.toml", model.config(analysis));
    runTool(std::string(name) + " --config " + path("options.toml") +
            " --print-config");
    const std::string printed = textOf("out.txt");
    AnalysisSettings read;
    write("printed.toml", printed);
    read.loadConfig(analysis, path("printed.toml"));
    EXPECT_EQ(read.config(analysis), model.config(analysis)) << name;
  }
}

// The copied command computes what the window shows.
TEST_F(ViewAndTool, CommandLineComputesTheSame)
{
  open(writeWire());
  model.settings.set(Analysis::Tensor, "radius", "0.7");
  model.settings.set(Analysis::Tensor, "engine", "tree");
  model.compute(Analysis::Tensor);
  model.wait();
  std::string line = model.commandLine(Analysis::Tensor);
  const std::string lead = "linelet ";
  ASSERT_EQ(line.compare(0, lead.size(), lead), 0);
  line = line.substr(lead.size(), line.rfind(' ') - lead.size());
  runTool(line + " " + path("tensor.las"));
  const io::Cloud cloud = io::readCloud(path("tensor.las"));
  const std::vector<float> seen = model.values("tensor.linearity");
  ASSERT_EQ(cloud.points.size(), seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto written = static_cast<float>(io::valueAt(*cloud.find("linearity"), i));
    EXPECT_TRUE(seen[i] == written || (std::isnan(seen[i]) && std::isnan(written)))
        << i;
  }
}

// A wire rejected in the viewer is missing from the tool's next run.
TEST_F(ViewAndTool, ReviewReachesTheTool)
{
  const std::string scene = std::string(LINELET_SOURCE_DIR) + "/data/corridor.las";
  runTool("powerlines " + scene + " " + path("first"));
  open(path("first"));
  const std::size_t before = model.lines()->wires.size();
  ASSERT_GT(before, 1u);
  const int doubtful = model.wiresByConfidence().front();
  model.setReview(doubtful, {powerline::Review::Verdict::Rejected, -1, "gone"});
  const int kept = doubtful == 1 ? 2 : 1;
  model.setReview(kept, {powerline::Review::Verdict::Accepted, 13, "stays"});
  runTool("powerlines --reviewed " + model.reviewFile() + " " + scene + " " +
          path("second"));
  Model again;
  again.open({path("second")});
  EXPECT_EQ(again.wait().error, "");
  EXPECT_EQ(again.lines()->wires.size(), before - 1);
  std::size_t notes = 0, guarded = 0;
  for (const powerline::Wire& wire : again.lines()->wires)
    notes += again.review(wire.id).note == "stays" ? 1 : 0;
  for (const float number : again.values("classification"))
    guarded += number == 13 ? 1 : 0;
  EXPECT_EQ(notes, 1u);
  EXPECT_GT(guarded, 10u);
}

// Jumpers and insulators are read back in place: the length of the course is the stated
// one, it runs through the cloud, and the ends of a string are its length apart.
TEST_F(ViewAndTool, FittingsOfATowerAreInTheirPlace)
{
  LINELET_NEEDS_DATA("lidar/uav_towers");
  std::vector<std::filesystem::path> towers;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::dataPath("lidar/uav_towers")))
    if (entry.path().extension() == ".las" || entry.path().extension() == ".laz")
      towers.push_back(entry.path());
  ASSERT_FALSE(towers.empty());
  runTool("powerlines " + std::min_element(towers.begin(), towers.end())->string() +
          " " + path("tower"));
  open(path("tower"));
  const powerline::PowerLineNetwork& found = *model.lines();
  ASSERT_FALSE(found.jumpers.empty());
  ASSERT_FALSE(found.insulators.empty());
  Point low = model.scene().cloud.points.front(), high = low;
  for (const Point& p : model.scene().cloud.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const auto inCloud = [&](const Point& of_network) {
    const Point p = model.toCloud(of_network);
    return ((p - low).array() > -1).all() && ((high - p).array() > -1).all();
  };
  for (const powerline::Jumper& jumper : found.jumpers) {
    double length = 0;
    for (std::size_t k = 1; k < jumper.course.size(); ++k)
      length += (jumper.course[k] - jumper.course[k - 1]).norm();
    EXPECT_NEAR(length, jumper.length, 0.01) << jumper.id;
    for (const Point& p : jumper.course)
      EXPECT_TRUE(inCloud(p)) << jumper.id;
  }
  for (const powerline::InsulatorString& string : found.insulators) {
    EXPECT_NEAR((string.live - string.structure).norm(), string.length, 0.01);
    EXPECT_TRUE(inCloud(string.live) && inCloud(string.structure)) << string.id;
  }
}

} // namespace
