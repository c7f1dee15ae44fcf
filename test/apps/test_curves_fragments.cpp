// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Curves in fragments are those of the whole cloud, to the last digit.

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <random>
#include <sstream>
#include <thread>

#include <linelet/io/vector_file.h>

#include "random_seed.h"
#include "tiles_test.h"

namespace linelet::test {

class CurvesFragmentsTest : public TilesTest {
protected:
  const std::string job_ = "curves --threads 1 ";
};

TEST_F(CurvesFragmentsTest, OfAFolderAreThoseOfTheWhole)
{
  std::mt19937 random(randomSeed());
  runWell(job_ + path("tiles") + " " + path("a.obj"));
  ASSERT_GT(io::readCurves(path("a.obj")).curves.size(), 20U);
  std::vector<double> chunks = {95};
  for (int i = 0; i < 3; ++i)
    chunks.push_back(std::uniform_real_distribution<double>(60, 260)(random));
  for (const double chunk : chunks) {
    runWell(job_ + path("tiles") + " " + path("b.obj") + " --chunk " +
            std::to_string(chunk) + " --json " + path("b.json"));
    EXPECT_GT(json(path("b.json"))["fragments"], 1);
    EXPECT_FALSE(fs::exists(path("b.obj.fragments"))) << "nothing must remain";
    EXPECT_TRUE(contents(path("a.obj")) == contents(path("b.obj")))
        << "chunk " << chunk;
  }
}

TEST_F(CurvesFragmentsTest, VerbsAndKilledRunsWriteTheSameBytes)
{
  std::mt19937 random(randomSeed());
  const std::string chunk = " --chunk 150";
  runWell(job_ + path("tiles") + " " + path("a.obj") + chunk);
  runWell("plan " + job_ + path("tiles") + " " + path("b.obj") + chunk);
  EXPECT_EQ(run("status " + path("b.obj")).code, 1) << "not done yet";
  expectOneLineOf("merge " + path("b.obj"), "--partial");
  const pid_t one = start({"work", path("b.obj")});
  runWell("work " + path("b.obj") + " --every 2/2");
  EXPECT_EQ(waitFor(one), 0);
  runWell("merge " + path("b.obj"));
  EXPECT_TRUE(contents(path("a.obj")) == contents(path("b.obj")));

  std::vector<std::string> arguments;
  std::istringstream words(job_ + path("tiles") + " " + path("c.obj") + chunk);
  for (std::string word; words >> word;)
    arguments.push_back(word);
  killAgainAndAgain(arguments, path("c.obj"), 6, random);
  runWell(job_ + path("tiles") + " " + path("c.obj") + chunk + " --resume");
  EXPECT_TRUE(contents(path("a.obj")) == contents(path("c.obj")));
}

TEST_F(CurvesFragmentsTest, UnsupportedOptionsAreRefused)
{
  const std::string in = "curves --chunk 90 " + path("tiles") + " ";
  expectOneLineOf(in + path("a.obj") + " --preset published", "--preset");
  expectOneLineOf(in + path("a.h5"), "a.h5");
}

// Without the warning, running out of memory would be a mystery.
TEST_F(CurvesFragmentsTest, UncuttableCloudsAreReported)
{
  std::string helix;
  for (int k = 0; k < 8000; ++k) {
    char line[80];
    const double t = 0.005 * k;
    std::snprintf(line,
                  sizeof(line),
                  "%.4f %.4f %.4f\n",
                  9 * std::cos(t),
                  9 * std::sin(t),
                  3 * t);
    helix += line;
  }
  write("helix.xyz", helix);
  runWell("convert " + path("helix.xyz") + " " + path("helix.las"));
  const std::string job = "curves " + path("helix.las") + " " + path("b.obj");
  const Outcome outcome = runWell(job + " --memory 1M");
  EXPECT_NE(outcome.error.find("--memory"), std::string::npos) << outcome.error;
  EXPECT_EQ(runWell(job + " --chunk 9").error, "") << "there is enough";
}

// A single point, and points that no curve can run through.
TEST_F(CurvesFragmentsTest, DegenerateInputs)
{
  write("one.xyz", "1 2 3\n");
  write("same.xyz", "1 2 3\n1 2 3\n1 2 3\n");
  for (const std::string name : {"one", "same"}) {
    runWell("convert " + path(name + ".xyz") + " " + path(name + ".las"));
    runWell("curves --chunk 1 " + path(name + ".las") + " " + path("b.obj") +
            " --json " + path("b.json"));
    EXPECT_EQ(json(path("b.json"))["curves"], 0);
  }
}

} // namespace linelet::test
