// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Runs in fragments give, byte for byte, the result of a run in one piece, whatever
// interrupts them.

#include <chrono>
#include <csignal>
#include <random>
#include <thread>
#include <vector>

#include <sys/mount.h>

#include "random_seed.h"
#include "test_data.h"
#include "tiles_test.h"

namespace linelet::test {

#define ENGINE "grid"

class FragmentsTest : public TilesTest {
protected:
  const std::string options_ = " --radius 1.5 --engine " ENGINE " ";
};

TEST_F(FragmentsTest, TensorOfOneFileIsTheSameForAnyChunk)
{
  const std::string in = path("whole.laz");
  runWell("tensor" + options_ + in + " " + path("a.las"));
  for (const std::string chunk : {"17.3", "40", "1000"}) {
    runWell("tensor" + options_ + in + " " + path("b.las") + " --chunk " + chunk);
    EXPECT_TRUE(contents(path("a.las")) == contents(path("b.las"))) << chunk;
    EXPECT_FALSE(fs::exists(path("b.las.fragments"))) << "nothing must remain";
  }
}

TEST_F(FragmentsTest, TensorOfTilesIsThatOfTheWholeFolder)
{
  runWell("tensor" + options_ + path("tiles") + " " + path("a"));
  runWell("tensor" + options_ + path("tiles") + " " + path("b") + " --chunk 33");
  EXPECT_TRUE(folderContents(path("a")) == folderContents(path("b")));
  // Cut to fit memory; crowded boxes are cut further.
  runWell("tensor" + options_ + path("tiles") + " " + path("c") +
          " --memory 20M --json " + path("c.json"));
  EXPECT_TRUE(folderContents(path("a")) == folderContents(path("c")));
  EXPECT_GT(json(path("c.json"))["fragments"], 1);
}

TEST_F(FragmentsTest, MultiscaleIsTheSame)
{
  const std::string job = "multiscale --radii 0.5,1,2,4 --engine grid " + path("tiles");
  runWell(job + " " + path("a"));
  runWell(job + " " + path("b") + " --chunk 47 --json " + path("b.json"));
  EXPECT_TRUE(folderContents(path("a")) == folderContents(path("b")));
  runWell("multiscale --radii 0.5,1,2,4 --engine grid " + path("whole.laz") + " " +
          path("c.las") + " --json " + path("c.json"));
  EXPECT_NEAR(
      json(path("b.json"))["noise_rate"], json(path("c.json"))["noise_rate"], 1e-9);
}

TEST_F(FragmentsTest, VerbsDoTheSameInWorkersOfTheirOwn)
{
  const std::string job = "tensor" + options_ + path("tiles") + " ";
  runWell(job + path("a"));
  const Outcome planned = runWell("plan " + job + path("b") + " --chunk 45");
  EXPECT_NE(planned.out.find("fragments"), std::string::npos);
  EXPECT_EQ(run("status " + path("b")).code, 1) << "not done yet";
  expectOneLineOf("merge " + path("b"), "--partial");
  runWell("work " + path("b") + " --task 0");
  runWell("work " + path("b") + " --tasks 1-2");
  expectOneLineOf("work " + path("b") + " --task 0 --tasks 1-2", "excludes");
  expectOneLineOf("work " + path("b") + " --task one", "number of a fragment");
  // Two workers on the same tasks, then each on its half.
  const pid_t one = start({"work", path("b")}), other = start({"work", path("b")});
  runWell("work " + path("b") + " --every 1/2");
  runWell("work " + path("b") + " --every 2/2");
  EXPECT_EQ(waitFor(one), 0);
  EXPECT_EQ(waitFor(other), 0);
  write("work.toml", runWell("work " + path("b") + " --print-config").out);
  runWell("work --config " + path("work.toml"));
  runWell("status " + path("b") + " --json " + path("s.json"));
  EXPECT_EQ(json(path("s.json"))["left"], 0);
  runWell("merge " + path("b"));
  EXPECT_TRUE(folderContents(path("a")) == folderContents(path("b")));
}

TEST_F(FragmentsTest, AnInputThatChangedIsRefused)
{
  runWell("plan tensor" + options_ + path("tiles") + " " + path("b") + " --chunk 45");
  runWell("work " + path("b") + " --task 0");
  fs::last_write_time(tile(2), fs::last_write_time(tile(2)) + std::chrono::seconds(1));
  expectOneLineOf("work " + path("b"), tile(2));
  expectOneLineOf("merge " + path("b"), tile(2));
}

TEST_F(FragmentsTest, ATruncatedTileIsNamedAndTheRestIsKept)
{
  const std::string job = "tensor" + options_ + path("tiles") + " ";
  runWell(job + path("a"));
  const std::string whole = contents(tile(3));
  fs::resize_file(tile(3), whole.size() * 2 / 3);
  expectOneLineOf(job + path("b") + " --chunk 45", tile(3));
  write("tiles/t3.laz", whole);
  // The file has changed, so a plan made for the broken one is not resumed.
  expectOneLineOf(job + path("b") + " --chunk 45 --resume", "--resume");
  runWell(job + path("b") + " --chunk 45");
  EXPECT_TRUE(folderContents(path("a")) == folderContents(path("b")));
}

// Each fragment reads the COPC nodes it touches; nothing is cut beforehand.
TEST_F(FragmentsTest, OctreesAreReadByWindow)
{
  LINELET_NEEDS_DATA("readers/copc");
  const std::string file =
      dataPath("readers/copc/silvimetric_test_data_2.copc.laz").string();
  runWell("info " + file + " --json " + path("copc.json"));
  const auto bounds = json(path("copc.json"))["bounds"];
  const double side =
      bounds["maximum"][0].get<double>() - bounds["minimum"][0].get<double>();
  for (const double parts : {2.0, 3.7}) {
    const std::string chunk = " --chunk " + std::to_string(side / parts);
    runWell("tensor" + options_ + file + " " + path("whole.laz"));
    runWell("plan tensor" + options_ + file + " " + path("parts.laz") + chunk);
    runWell("work " + path("parts.laz"));
    EXPECT_FALSE(fs::exists(path("parts.laz.fragments/cut")));
    EXPECT_FALSE(fs::exists(path("parts.laz.fragments/pieces")));
    runWell("merge " + path("parts.laz"));
    EXPECT_TRUE(contents(path("whole.laz")) == contents(path("parts.laz")));
  }
}

TEST_F(FragmentsTest, PartialResultsNeedAnOptionAndAreReported)
{
  runWell("plan tensor" + options_ + path("tiles") + " " + path("b") + " --chunk 45");
  runWell("work " + path("b") + " --tasks 0-1");
  const Outcome outcome = run("merge " + path("b") + " --partial");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.error.find("missing"), std::string::npos);
  EXPECT_TRUE(fs::exists(path("b/t0.laz")));
}

// Killed 50 times at arbitrary moments, and resumed.
TEST_F(FragmentsTest, KilledAndResumedIsTheSame)
{
  std::mt19937 random(randomSeed());
  const std::string job = "tensor" + options_ + path("tiles") + " ";
  runWell(job + path("a") + " --chunk 12");
  killAgainAndAgain({"tensor",
                     "--radius",
                     "1.5",
                     "--engine",
                     ENGINE,
                     path("tiles"),
                     path("b"),
                     "--chunk",
                     "12"},
                    path("b"),
                    50,
                    random);
  runWell(job + path("b") + " --chunk 12 --resume");
  EXPECT_TRUE(folderContents(path("a")) == folderContents(path("b")));
  // A writer killed in the middle of an output leaves nothing either.
  for (const auto& file : fs::directory_iterator(path("b")))
    EXPECT_EQ(file.path().filename().string().find(".part-"), std::string::npos)
        << file.path();
}

TEST_F(FragmentsTest, ASignalEndsAtOnceAndWhatIsDoneIsKept)
{
  const pid_t child = start({"tensor",
                             "--radius",
                             "6",
                             "--engine",
                             ENGINE,
                             path("tiles"),
                             path("b"),
                             "--chunk",
                             "12"});
  waitForWork(child, path("b"));
  const auto asked = std::chrono::steady_clock::now();
  ::kill(child, SIGTERM);
  const int status = waitFor(child);
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::milliseconds(2500));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
    GTEST_SKIP() << "was done before the signal";
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_GT(doneOf(path("b")), 0U);
}

// A full disk is reported, and the run continues once there is room.
TEST_F(FragmentsTest, DiskFull)
{
  fs::create_directories(path("disk"));
  if (::mount("none", path("disk").c_str(), "tmpfs", 0, "size=6m") != 0)
    GTEST_SKIP() << "needs its own file system, which only root may mount";
  const std::string job = "tensor" + options_ + path("tiles") + " ";
  runWell(job + path("a"));
  const std::string again = job + path("disk/b") + " --chunk 45 ";
  const Outcome outcome = run(again);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(lines(outcome.error), 1) << outcome.error;
  EXPECT_NE(outcome.error.find("No space left"), std::string::npos) << outcome.error;
  EXPECT_EQ(::mount("none", path("disk").c_str(), "tmpfs", MS_REMOUNT, "size=200m"), 0);
  runWell(again + " --resume");
  EXPECT_TRUE(folderContents(path("a")) == folderContents(path("disk/b")));
  ::umount(path("disk").c_str());
}

TEST_F(FragmentsTest, CommandsWithoutFragmentsSaySo)
{
  expectOneLineOf("plan convert a b", "convert");
  expectOneLineOf("plan tensor --knn 9 " + path("tiles") + " " + path("b"), "--radius");
  expectOneLineOf("work " + path("nothing"), "nothing");
  EXPECT_EQ(run("tensor --memory much " + path("tiles") + " " + path("b")).code, 2);
  EXPECT_EQ(run("plan --help").code, 0);
  EXPECT_EQ(run("plan").code, 2);
}

// Too small for any point: first point by point, then for a single point.
TEST_F(FragmentsTest, DegenerateInputs)
{
  write("one.xyz", "1 2 3\n");
  write("same.xyz", "1 2 3\n1 2 3\n1 2 3\n");
  for (const std::string name : {"one", "same"}) {
    runWell("convert " + path(name + ".xyz") + " " + path(name + ".las"));
    runWell("tensor" + options_ + path(name + ".las") + " " + path("a.las"));
    runWell("tensor" + options_ + path(name + ".las") + " " + path("b.las") +
            " --chunk 1");
    EXPECT_TRUE(contents(path("a.las")) == contents(path("b.las"))) << name;
  }
}

} // namespace linelet::test
