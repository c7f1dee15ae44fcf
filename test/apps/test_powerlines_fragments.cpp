// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Power lines found in fragments are those of the whole cloud, in every file but the
// pictures.

#include <chrono>
#include <random>
#include <thread>

#include <linelet/io/point_file.h>

#include "random_seed.h"
#include "tiles_test.h"

namespace linelet::test {

class PowerlinesFragmentsTest : public TilesTest {
protected:
  /** Whether both agree, places and lengths to a millimeter. Unexplained lines are left
   * out: they are searched for at the spacing of a fragment's points. */
  static void
  expectSame(const nlohmann::json& one,
             const nlohmann::json& other,
             const std::string& where)
  {
    if (where.find("unexplained") != std::string::npos)
      return;
    ASSERT_EQ(one.is_number(), other.is_number()) << where;
    if (one.is_number()) {
      // The constant of a flat catenary has only as many significant digits as its sag.
      const double value = one, apart = where == "a" ? 1e-3 * value : 1e-3;
      EXPECT_NEAR(value, other.get<double>(), apart) << where;
      return;
    }
    ASSERT_EQ(one.size(), other.size()) << where;
    if (one.is_object())
      for (const auto& [key, value] : one.items()) {
        ASSERT_TRUE(other.contains(key)) << key;
        expectSame(value, other.at(key), key);
      }
    else if (one.is_array())
      for (std::size_t k = 0; k < one.size(); ++k)
        expectSame(one[k], other[k], where);
    else
      EXPECT_EQ(one, other) << where;
  }

  void
  expectSameFiles(const std::string& one, const std::string& other) const
  {
    expectSame(
        json(path(one) + "/summary.json"), json(path(other) + "/summary.json"), "");
    const io::Cloud a = io::readCloud(path(one) + "/classified.laz"),
                    b = io::readCloud(path(other) + "/classified.laz");
    ASSERT_EQ(a.points.size(), b.points.size());
    EXPECT_TRUE(a.points == b.points) << "different order";
    ASSERT_EQ(a.columns.size(), b.columns.size());
    for (const io::Column& column : a.columns) {
      const io::Column* same = b.find(column.name);
      ASSERT_NE(same, nullptr) << column.name;
      if (column.name != "unexplained" && column.name != "wire_distance") {
        EXPECT_TRUE(column.values == same->values) << column.name;
      }
    }
    for (const auto& entry : fs::directory_iterator(path(one)))
      EXPECT_TRUE(fs::exists(fs::path(path(other)) / entry.path().filename()))
          << entry.path();
  }

  /** Locks held by workers. */
  static std::size_t
  locksIn(const std::string& folder)
  {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      count += entry.path().extension() == ".lock" ? 1 : 0;
    return count;
  }

  const std::string job_ = "powerlines --threads 1 ";
};

// A beginner's run: a folder of tiles that exceeds memory, cut anywhere.
TEST_F(PowerlinesFragmentsTest, OfAFolderAreThoseOfTheWhole)
{
  std::mt19937 random(randomSeed());
  const double chunk = std::uniform_real_distribution<double>(90, 260)(random);
  SCOPED_TRACE("chunk " + std::to_string(chunk));
  runWell(job_ + path("tiles") + " " + path("a"));
  runWell(job_ + path("tiles") + " " + path("b") + " --chunk " + std::to_string(chunk) +
          " --json " + path("b.json"));
  EXPECT_GT(json(path("b.json"))["fragments"], 1);
  EXPECT_GT(json(path("b.json"))["wires"], 20);
  expectSameFiles("a", "b");
  EXPECT_FALSE(fs::exists(path("b.fragments"))) << "nothing must remain";
}

// Wires that continue beyond a pole may end there on top of each other.
TEST_F(PowerlinesFragmentsTest, OfAStreetAreThoseOfTheWhole)
{
  runWell("generate scene street " + path("street.laz") + " --seed 8");
  runWell(job_ + path("street.laz") + " " + path("a"));
  runWell(job_ + path("street.laz") + " " + path("b") + " --chunk 71.3");
  expectSameFiles("a", "b");
}

TEST_F(PowerlinesFragmentsTest, AreCutForMemory)
{
  runWell(job_ + path("tiles") + " " + path("a"));
  runWell(job_ + path("tiles") + " " + path("b") + " --memory 8M --buffer 60 --json " +
          path("b.json"));
  EXPECT_GT(json(path("b.json"))["fragments"], 1);
  EXPECT_EQ(json(path("a/summary.json"))["points"],
            json(path("b/summary.json"))["points"]);
}

// A warning says when fragments overlap by less than a span.
TEST_F(PowerlinesFragmentsTest, WarnOfSpansBeyondTheBuffer)
{
  const Outcome outcome =
      runWell(job_ + path("tiles") + " " + path("b") + " --chunk 90 --buffer 20");
  EXPECT_NE(outcome.error.find("--buffer"), std::string::npos) << outcome.error;
}

TEST_F(PowerlinesFragmentsTest, VerbsDoTheSameInWorkersOfTheirOwn)
{
  runWell(job_ + path("tiles") + " " + path("a"));
  runWell("plan " + job_ + path("tiles") + " " + path("b") + " --chunk 130");
  EXPECT_EQ(run("status " + path("b")).code, 1) << "not done yet";
  expectOneLineOf("merge " + path("b"), "--partial");
  const pid_t one = start({"work", path("b"), "--every", "1/2"});
  runWell("work " + path("b") + " --every 2/2");
  EXPECT_EQ(waitFor(one), 0);
  runWell("merge " + path("b"));
  expectSameFiles("a", "b");
  EXPECT_EQ(locksIn(path("b.fragments")), 0U);
}

TEST_F(PowerlinesFragmentsTest, ReviewsAreRefused)
{
  write("judged.csv", "wire_id,review\n");
  expectOneLineOf(job_ + "--reviewed " + path("judged.csv") + " --chunk 100 " +
                      path("tiles") + " " + path("b"),
                  "--reviewed");
}

// A run killed while it removes the folder of a finished run must not count as done
// without results.
TEST_F(PowerlinesFragmentsTest, RemainsOfAFinishedRunAreNotResumed)
{
  const std::string job =
      "powerlines --threads 1 " + path("whole.laz") + " " + path("b") + " --chunk 200";
  runWell("plan " + job);
  runWell("work " + path("b"));
  runWell("merge " + path("b"));
  fs::remove(path("b.fragments/plan.json"));
  fs::remove_all(path("b.fragments/output"));
  runWell(job + " --resume");
  EXPECT_FALSE(fs::exists(path("b.fragments")));
}

// A worker that is told to stop does so within two seconds, and the run can be resumed.
TEST_F(PowerlinesFragmentsTest, AWorkerHeedsSignals)
{
  runWell(job_ + path("tiles") + " " + path("a"));
  runWell("plan " + job_ + path("tiles") + " " + path("b") + " --chunk 60");
  const pid_t child = start({"work", path("b")});
  waitForWork(child, path("b"));
  const auto asked = std::chrono::steady_clock::now();
  ::kill(child, SIGTERM);
  const int status = waitFor(child);
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(2));
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == 0)
    GTEST_SKIP() << "was done before the signal";
  EXPECT_EQ(WEXITSTATUS(status), 1);
  runWell("work " + path("b"));
  runWell("merge " + path("b"));
  expectSameFiles("a", "b");
}

} // namespace linelet::test
