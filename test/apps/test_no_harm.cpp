// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// No input is ever destroyed, and no foreign file is replaced unless asked.

#include <filesystem>

#include <sys/stat.h>

#include <gmock/gmock.h>

#include <linelet/io/point_file.h>

#include "run_tool.h"

namespace linelet::test {

namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class NoHarm : public ToolTest {
protected:
  /** \brief A few points of two wires, as a file. */
  std::string
  cloud(const std::string& name, double offset = 0) const
  {
    io::Cloud cloud;
    for (int i = 0; i < 300; ++i)
      for (const double y : {0.0, 4.0})
        cloud.points.emplace_back(
            0.2 * i + offset, y, 10 + 1e-3 * (i - 150) * (i - 150));
    io::writeCloud(path(name), cloud);
    return path(name);
  }

  /** \brief Runs what must be rejected with one line; \a input must stay unchanged. */
  void
  expectKeeps(const std::string& arguments, const std::string& input) const
  {
    const std::string before = contents(input);
    ASSERT_FALSE(before.empty());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 1) << arguments;
    EXPECT_EQ(lines(outcome.error), 1) << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr("is the input")) << arguments;
    EXPECT_EQ(contents(input), before) << arguments;
  }
};

} // namespace

TEST_F(NoHarm, AnOutputIsNeverTheInput)
{
  const std::string in = cloud("in.las");
  fs::create_symlink(in, path("link.las"));
  fs::create_hard_link(in, path("hard.las"));
  fs::create_directories(path("folder"));
  fs::create_directory_symlink(path(""), path("folder/back"));
  for (const std::string& name : {in,
                                  path("link.las"),
                                  path("hard.las"),
                                  path("./folder/../in.las"),
                                  path("folder/back/in.las")})
    for (const std::string command : {"convert", "tensor", "multiscale"}) {
      expectKeeps(command + " " + in + " " + name, in);
      expectKeeps(command + " " + name + " " + in, in);
    }
}

TEST_F(NoHarm, NorIsAnyOtherOutput)
{
  const std::string in = cloud("in.ply"), csv = cloud("in.csv");
  for (const std::string command : {"convert ", "tensor ", "multiscale "})
    expectKeeps(command + in + " " + path("out.las") + " --json " + in, in);
  expectKeeps("info " + in + " --json " + in, in);
  expectKeeps("multiscale " + csv + " " + path("out.las") + " --graphs " + csv, csv);
  expectKeeps("curves " + in + " " + in, in);
  expectKeeps("curves " + in + " " + path("out.obj") + " --json " + in, in);
  expectKeeps("powerlines " + in + " " + path("out") + " --json " + in, in);

  runWell("generate circle " + path("circle.xyz") + " --truth " + path("truth.obj"));
  const std::string truth = path("truth.obj");
  expectKeeps("evaluate " + truth + " " + truth + " --json " + truth, truth);
  fs::copy_file(truth, path("truth.png"));
  expectKeeps("image " + path("circle.xyz") + " " + path("truth.png") + " --curves " +
                  path("truth.png"),
              path("truth.png"));

  const std::string options = write("options.toml", "radius=1.5\n");
  expectKeeps("tensor " + in + " " + path("out.las") + " --config " + options +
                  " --json " + options,
              options);
}

TEST_F(NoHarm, TheShiftOfAnInputIsPartOfIt)
{
  cloud("far.las", 500000);
  runWell("convert --shifted " + path("far.las") + " " + path("near.ply"));
  expectKeeps("info " + path("near.ply") + " --json " + path("near.ply.shift"),
              path("near.ply.shift"));
}

TEST_F(NoHarm, TwoOutputsAreTwoFiles)
{
  const std::string in = cloud("in.las"), out = path("out.csv");
  fs::create_directory_symlink(path(""), path("same"));
  for (const std::string& other : {out, path("same/out.csv")})
    expectOneLineOf("multiscale " + in + " " + out + " --graphs " + other,
                    "two outputs");
  expectOneLineOf("generate circle " + out + " --truth " + out, "two outputs");
  EXPECT_FALSE(fs::exists(out));
  runWell("convert " + in + " " + path("out.las") + " --json /dev/null");
}

TEST_F(NoHarm, ResultsNeverReplaceTheirInput)
{
  fs::create_directories(path("d"));
  const std::string in = cloud("d/classified.las");
  expectKeeps("powerlines " + in + " " + path("d"), in);
  expectKeeps("powerlines " + in + " " + path("d") + " --overwrite", in);
  fs::create_directory_symlink(path("d"), path("e"));
  expectKeeps("powerlines " + in + " " + path("e"), in);
}

TEST_F(NoHarm, ResultsOfAnotherInputAreKept)
{
  const std::string one = cloud("one.las"), other = cloud("other.las", 1000);
  const std::string folder = path("out");
  runWell("powerlines " + one + " " + folder);
  const std::string before = contents(folder + "/classified.las");
  expectOneLineOf("powerlines " + other + " " + folder, "one.las");
  EXPECT_EQ(contents(folder + "/classified.las"), before);
  runWell("powerlines " + one + " " + folder + " --clearance 4");
  // A file of the same name, but another cloud.
  fs::create_directories(path("second"));
  const std::string namesake = cloud("second/one.las", 2000);
  expectOneLineOf("powerlines " + namesake + " " + folder, "another one.las");
  runWell("powerlines " + other + " " + folder + " --overwrite");
  EXPECT_EQ(json(folder + "/summary.json")["source"], "other.las");
  // A folder is the same, however its path is written.
  fs::create_directories(path("tiles"));
  cloud("tiles/a.las");
  runWell("powerlines " + path("tiles/") + " " + folder + " --overwrite");
  EXPECT_EQ(json(folder + "/summary.json")["source"], "tiles");
  runWell("powerlines " + other + " " + folder + " --overwrite");
  // Results of an unknown origin.
  fs::remove(folder + "/summary.json");
  expectOneLineOf("powerlines " + other + " " + folder, "unknown input");
  write("out/summary.json", "{]");
  expectOneLineOf("powerlines " + other + " " + folder, "unknown input");
  // Files of other kinds are left alone.
  fs::create_directories(path("notes"));
  write("notes/todo.txt", "prune");
  runWell("powerlines " + one + " " + path("notes"));
}

TEST_F(NoHarm, UnwritablePathsAreReportedInOneSentence)
{
  const std::string in = cloud("in.las");
  fs::create_directories(path("closed/inner"));
  fs::permissions(path("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  // Root may write anywhere, but not even root into procfs.
  const std::string closed = geteuid() == 0 ? "/proc" : path("closed");
  const std::vector<std::string> commands = {
      "convert " + in + " " + closed + "/out.las",
      "tensor " + in + " " + closed + "/out.las",
      "multiscale " + in + " " + closed + "/out.las",
      "multiscale " + in + " " + path("o.las") + " --graphs " + closed + "/g.csv",
      "curves " + in + " " + closed + "/out.gpkg",
      "curves " + in + " " + closed + "/out.dxf",
      "powerlines " + in + " " + closed + "/out",
      "powerlines " + in + " " + path("no.las") + "/out",
      "image " + in + " " + closed + "/out.png --color height",
      "generate circle " + closed + "/out.xyz",
      "generate circle " + path("c.xyz") + " --truth " + closed + "/out.obj",
      "generate corridor " + closed + "/out.las",
      "benchmark --sample 1 --out " + closed + "/rows.csv",
      "benchmark --sample 1 --plot " + closed + "/rows.png",
      "info " + in + " --json " + closed + "/out.json",
      "convert " + in + " " + path("missing/out.las"),
      "curves " + in + " " + path("missing/out.gpkg"),
      "info " + path("missing/in.las"),
      "info " + closed,
      "evaluate " + path("missing.obj") + " " + path("missing.obj")};
  write("no.las", "a file where a folder should be");
  for (const std::string& command : commands) {
    SCOPED_TRACE(command);
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(lines(outcome.error), 1) << outcome.error;
    EXPECT_THAT(outcome.error, testing::Not(HasSubstr("filesystem error")));
  }
  fs::permissions(path("closed"), fs::perms::owner_all);
}

TEST_F(NoHarm, FileNamesMayBeOdd)
{
  const std::string in = cloud("in.las");
  const std::string longest(251, 'n');
  for (const std::string& stem :
       {std::string("two words"), std::string("Überland-Leitung 電線"), longest}) {
    SCOPED_TRACE(stem);
    const auto quoted = [&](const std::string& ending) {
      return "'" + path(stem + ending) + "'";
    };
    runWell("convert " + in + " " + quoted(".las"));
    runWell("info " + quoted(".las") + " --json " + path("info.json"));
    EXPECT_EQ(json(path("info.json"))["points"], 600);
    runWell("tensor " + quoted(".las") + " " + quoted(".ply"));
    runWell("curves " + quoted(".las") + " " + quoted(".obj"));
    runWell("curves " + quoted(".las") + " " + quoted(".dxf"));
    runWell("image " + quoted(".las") + " " + quoted(".png") + " --color height");
    runWell("powerlines " + quoted(".las") + " '" + path(stem) + "'");
    fs::remove(path(stem + ".obj"));
  }
  runWell("curves " + in + " '" + path("電線 2") + ".gpkg'");
  runWell("curves " + in + " " + path(std::string(250, 'g') + ".gpkg"));
  for (const auto& entry : fs::recursive_directory_iterator(path("")))
    EXPECT_NE(entry.path().filename().string().rfind(".part", 0), 0u) << entry.path();

  const std::string too_long = path(std::string(300, 'n') + ".las");
  expectOneLineOf("convert " + in + " " + too_long, "name too long");
  expectOneLineOf("info " + too_long, "name too long");
  expectOneLineOf("powerlines " + in + " " + path(std::string(300, 'd')),
                  "name too long");
}

TEST_F(NoHarm, DegreesAreReportedByEveryMeasurement)
{
  std::string text = "x,y,z\n";
  for (int i = 0; i < 200; ++i)
    text += std::to_string(11.5 + 1e-5 * i) + "," + std::to_string(48.1 + 1e-6 * i) +
            "," + std::to_string(i % 10) + "\n";
  const std::string degrees = write("degrees.csv", text);
  for (const std::string& command : {"info " + degrees,
                                     "tensor " + degrees + " " + path("out.las"),
                                     "multiscale " + degrees + " " + path("out.las"),
                                     "curves " + degrees + " " + path("out.obj"),
                                     "image " + degrees + " " + path("out.png")})
    EXPECT_THAT(runWell(command).error, HasSubstr("look like degrees")) << command;
  expectOneLineOf("powerlines " + degrees + " " + path("out"), "look like degrees");
  EXPECT_EQ(runWell("convert " + degrees + " " + path("out.las")).error, "");

  io::Cloud told = io::readCloud(degrees);
  told.wkt = R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,)"
             R"(298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",)"
             R"(0.0174532925199433],AUTHORITY["EPSG","4326"]])";
  io::writeCloud(path("told.las"), told);
  EXPECT_THAT(runWell("tensor " + path("told.las") + " " + path("out.las")).error,
              HasSubstr("WGS 84 has the unit degree"));
  runWell("curves " + path("told.las") + " " + path("told.geojson"));
  EXPECT_THAT(
      runWell("evaluate " + path("told.geojson") + " " + path("told.geojson")).error,
      HasSubstr("has the unit degree"));
}

TEST_F(NoHarm, LongWorkIsAnnounced)
{
  // Twenty thousand points, each a neighbor of every other, one by one in double.
  std::string text;
  for (int i = 0; i < 40000; ++i)
    text += std::to_string(i % 97) + " " + std::to_string(i % 101) + " " +
            std::to_string(i % 89) + "\n";
  const std::string cloud = write("crowd.xyz", text);
  const std::string command =
      std::string("timeout -s TERM 3 ") + LINELET_TOOL + " tensor " + cloud + " " +
      path("out.las") + " --engine tree --threads 1 --radius 1e6 2> " + path("said");
  [[maybe_unused]] const int status = std::system(command.c_str());
  EXPECT_THAT(contents(path("said")), HasSubstr("less with a smaller --radius"));
}

} // namespace linelet::test
