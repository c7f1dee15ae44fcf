// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include <linelet/io/point_file.h>

#include "run_tool.h"

using namespace linelet;
using linelet::test::Outcome;
using linelet::test::ToolTest;
using testing::HasSubstr;

namespace {

class FileCommands : public ToolTest {
protected:
  /** \brief Four points in UTM coordinates with a class and a temperature. */
  std::string
  writeSmallCloud() const
  {
    return write("small.csv",
                 "x,y,z,classification,temperature\n"
                 "512000.125,5427000.5,200,2,-3.5\n"
                 "512001.125,5427000.5,200,2,4.25\n"
                 "512000.125,5427002.5,203,14,1e-3\n"
                 "512001.375,5427002.75,203.0625,14,7\n");
  }
};

void
expectSame(const io::Cloud& a, const io::Cloud& b)
{
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    EXPECT_LT((a.shift + a.points[i] - b.shift - b.points[i]).norm(), 1e-6) << i;
    for (const char* name : {"classification", "temperature"}) {
      ASSERT_NE(a.find(name), nullptr) << name;
      ASSERT_NE(b.find(name), nullptr) << name;
      EXPECT_EQ(io::valueAt(*a.find(name), i), io::valueAt(*b.find(name), i));
    }
  }
}

} // namespace

TEST_F(FileCommands, InfoListsTheContentsOfAFile)
{
  const std::string cloud = writeSmallCloud();
  const Outcome info = runWell("info " + cloud + " --json " + path("info.json"));
  EXPECT_THAT(info.out, HasSubstr("wire conductor"));
  const auto summary = json(path("info.json"));
  EXPECT_EQ(summary["file"], cloud);
  EXPECT_EQ(summary["points"], 4);
  EXPECT_EQ(summary["bounds"]["minimum"],
            (std::vector<double>{512000.125, 5427000.5, 200}));
  EXPECT_EQ(summary["bounds"]["maximum"],
            (std::vector<double>{512001.375, 5427002.75, 203.0625}));
  for (const char* key :
       {"format", "reference_system", "scale_unit", "density", "spacing"})
    EXPECT_TRUE(summary.contains(key)) << key;
  ASSERT_EQ(summary["classes"].size(), 2u);
  EXPECT_EQ(summary["classes"][1]["class"], 14);
  EXPECT_EQ(summary["classes"][1]["name"], "wire conductor");
  EXPECT_EQ(summary["classes"][1]["points"], 2);
  ASSERT_EQ(summary["attributes"].size(), 2u);
  EXPECT_EQ(summary["attributes"][1]["name"], "temperature");
  EXPECT_EQ(summary["attributes"][1]["minimum"], -3.5);
  EXPECT_EQ(summary["attributes"][1]["maximum"], 7);
}

TEST_F(FileCommands, InfoOfFewPointsIsValidJson)
{
  for (const char* points : {"x,y,z\n", "x,y,z\n1,2,3\n", "x,y,z\n1,2,3\n1,2,3\n"}) {
    const std::string cloud = write("few.csv", points);
    runWell("info " + cloud + " --json " + path("info.json"));
    EXPECT_EQ(json(path("info.json"))["points"], lines(points) - 1);
  }
}

TEST_F(FileCommands, UnreadableFilesAreNamedInOneLine)
{
  expectOneLineOf("info " + path("none.las"), path("none.las"));
  expectOneLineOf("info " + path(""), "is a folder");
  expectOneLineOf("info " + write("cloud.foo", "1 2 3\n"), path("cloud.foo"));
  expectOneLineOf("info " + write("cloud.laz", "LASF"), path("cloud.laz"));
  expectOneLineOf("info " + write("short.las", "LASF"), path("short.las"));
  expectOneLineOf("info " + write("empty.xyz", ""), path("empty.xyz"));
  expectOneLineOf("info " + write("comma.csv", "x;y;z\n1,5;2;3\n"), "line 2: numbers");
  expectOneLineOf("info " + write("comma.txt", "1,5;2;3\n1,5;2;3\n"), "decimal commas");
  expectOneLineOf("convert " + writeSmallCloud() + " " + path("out.foo"),
                  path("out.foo"));
  expectOneLineOf("convert " + path("small.csv") + " " + path("no/folder/out.las"),
                  path("no/folder/out.las"));
}

TEST_F(FileCommands, ConversionsKeepPointsAndAttributes)
{
  const std::string first = writeSmallCloud();
  std::string last = first;
  for (const char* ending : {".xyz", ".las", ".pcd", ".ply", ".csv", ".xyz"}) {
    SCOPED_TRACE(ending);
    const std::string next = path(std::string("next") + ending);
    runWell("convert " + last + " " + next + " --json " + path("convert.json"));
    EXPECT_EQ(json(path("convert.json"))["points"], 4);
    expectSame(io::readCloud(first), io::readCloud(next));
    last = next;
  }
}

TEST_F(FileCommands, ATruncatedFileIsReadOnlyOnRequest)
{
  const std::string whole = path("whole.las"), output = path("out.xyz");
  runWell("generate helix " + whole + " --points 64");
  const std::string bytes = contents(whole);
  const std::string cut = write("cut.las", bytes.substr(0, bytes.size() - 30));

  expectOneLineOf("convert " + cut + " " + output, cut);
  EXPECT_FALSE(std::filesystem::exists(output));
  const Outcome lenient = runWell("convert " + cut + " " + output + " --lenient");
  EXPECT_EQ(lines(lenient.error), 1);
  EXPECT_THAT(lenient.error, HasSubstr("warning: " + cut));
  // 20 bytes per point: the last two are damaged.
  EXPECT_EQ(io::readCloud(output).points.size(), 62u);
}

TEST_F(FileCommands, UnwritableOutputsAreRefusedBeforeTheWork)
{
  // With input and output both bad, the output is reported: nothing has been read yet.
  for (const std::string command : {"tensor ", "multiscale ", "curves "})
    for (const std::string output : {"out.foo", "no/folder/out.ply"})
      expectOneLineOf(command + path("none.las") + " " + path(output), path(output));
  expectOneLineOf("curves " + path("none.las") + " " + path("out.las"), "out.las");
  expectOneLineOf("tensor " + path("none.las") + " " + path("out.gpkg"), "out.gpkg");
  expectOneLineOf("convert " + path("none.las") + " " + path("out.foo"), "out.foo");
  expectOneLineOf("image " + path("none.las") + " " + path("no/out.png"), "no/out.png");
  // The same for outputs beside the main one.
  for (const std::string call : {"info none.las --json ",
                                 "multiscale none.las out.las --graphs ",
                                 "generate circle out.las --truth ",
                                 "generate corridor out.las --truth ",
                                 "generate scene town out.las --structures ",
                                 "benchmark --sample 1 --plot "})
    expectOneLineOf("" + call + path("no/folder/out.png"), path("no/folder/out.png"));
  expectOneLineOf("benchmark --sample 1 --plot " + path("out.jpg"), path("out.jpg"));
  // Checking leaves a writable file untouched.
  write("kept.ply", "what was here before");
  expectOneLineOf("curves " + path("none.las") + " " + path("kept.ply"), "none.las");
  EXPECT_EQ(contents(path("kept.ply")), "what was here before");
  const auto files = std::filesystem::directory_iterator(path(""));
  EXPECT_EQ(std::distance(begin(files), end(files)), 3) << "kept.ply, stdout, stderr";
}

TEST_F(FileCommands, AFailureLeavesNoOutput)
{
  const std::string cloud = writeSmallCloud();
  write("kept.las", "what was here before");
  expectOneLineOf("convert " + path("none.csv") + " " + path("kept.las"), "none.csv");
  EXPECT_EQ(contents(path("kept.las")), "what was here before");
  expectOneLineOf("image " + cloud + " " + path("picture.jpg"), path("picture.jpg"));
  expectOneLineOf("curves " + cloud + " " + path("curves.foo"), path("curves.foo"));
  expectOneLineOf("multiscale " + cloud + " " + path("out.foo"), path("out.foo"));
  for (const char* name : {"picture.jpg", "curves.foo", "out.foo"})
    EXPECT_FALSE(std::filesystem::exists(path(name))) << name;
}
