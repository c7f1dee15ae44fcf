// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// What can go wrong while power lines and curves run in fragments: it is reported in
// one sentence, and once it is fixed, the result is that of an undisturbed run.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iterator>
#include <ostream>
#include <random>
#include <sstream>
#include <thread>

#include <sys/mount.h>
#include <sys/resource.h>

#include "random_seed.h"
#include "tiles_test.h"

namespace linelet::test {

/** \brief A command, and which of its files hold the result. */
struct FaultyJob {
  const char* command;
  const char* output;
  std::vector<std::string> files; ///< relative to the output; empty: the output itself
};

void
PrintTo(const FaultyJob& job, std::ostream* out)
{
  *out << job.command;
}

class FragmentFaultsTest : public TilesTest,
                           public testing::WithParamInterface<FaultyJob> {
protected:
  std::string
  job(const std::string& folder, int chunk = 150) const
  {
    return std::string(GetParam().command) + " --threads 1 --chunk " +
           std::to_string(chunk) + " " + path("tiles") + " " + output(folder);
  }

  std::string
  output(const std::string& folder) const
  {
    fs::create_directories(path(folder));
    return path(folder) + "/" + GetParam().output;
  }

  std::string
  result(const std::string& folder) const
  {
    if (GetParam().files.empty())
      return contents(output(folder));
    std::string all;
    for (const std::string& file : GetParam().files)
      all += contents(output(folder) + "/" + file);
    return all;
  }

  void
  expectSame(const std::string& one, const std::string& other) const
  {
    EXPECT_GT(result(one).size(), 1000U);
    EXPECT_TRUE(result(one) == result(other));
  }
};

TEST_P(FragmentFaultsTest, DiskFull)
{
  fs::create_directories(path("disk"));
  if (::mount("none", path("disk").c_str(), "tmpfs", 0, "size=1m") != 0)
    GTEST_SKIP() << "needs its own file system, which only root may mount";
  runWell(job("a"));
  const Outcome outcome = run(job("disk"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.error.find("No space left"), std::string::npos) << outcome.error;
  EXPECT_EQ(::mount("none", path("disk").c_str(), "tmpfs", MS_REMOUNT, "size=200m"), 0);
  runWell(job("disk") + " --resume");
  expectSame("a", "disk");
  ::umount(path("disk").c_str());
}

TEST_P(FragmentFaultsTest, ATruncatedTileIsNamed)
{
  runWell(job("a"));
  const std::string whole = contents(tile(3));
  fs::resize_file(tile(3), whole.size() * 2 / 3);
  const Outcome outcome = run(job("b"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.error.find(tile(3)), std::string::npos) << outcome.error;
  write("tiles/t3.laz", whole);
  runWell(job("b"));
  expectSame("a", "b");
}

TEST_P(FragmentFaultsTest, AnInputThatChangedIsRefused)
{
  runWell("plan " + job("b"));
  runWell("work " + output("b") + " --task 0");
  fs::last_write_time(tile(2), fs::last_write_time(tile(2)) + std::chrono::seconds(1));
  expectOneLineOf("work " + output("b"), tile(2));
  expectOneLineOf("merge " + output("b"), tile(2));
}

TEST_P(FragmentFaultsTest, TwoWorkersOnTheSameTasks)
{
  runWell(job("a"));
  runWell("plan " + job("b"));
  const pid_t one = start({"work", output("b")}), other = start({"work", output("b")});
  EXPECT_EQ(waitFor(one), 0);
  EXPECT_EQ(waitFor(other), 0);
  runWell("merge " + output("b"));
  expectSame("a", "b");
}

/** \brief Seconds of CPU time that the children that were waited for have used. */
double
cpuOfChildren()
{
  rusage usage = {};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Within two seconds on every core, in CPU time: a busy machine takes longer.
TEST_P(FragmentFaultsTest, ASignalEndsItSoon)
{
  runWell(job("a"));
  runWell("plan " + job("b"));
  const double cpu_before = cpuOfChildren();
  const pid_t child = start({"work", output("b")});
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  ::kill(child, SIGTERM);
  const int status = waitFor(child);
  EXPECT_LT(cpuOfChildren() - cpu_before,
            (0.6 + 2) * std::max(1U, std::thread::hardware_concurrency()));
  ASSERT_TRUE(WIFEXITED(status));
  runWell("work " + output("b"));
  runWell("merge " + output("b"));
  expectSame("a", "b");
}

// Killed at arbitrary moments and resumed; LINELET_TEST_KILLS=50 asks for more kills.
TEST_P(FragmentFaultsTest, KilledAndResumed)
{
  std::mt19937 random(randomSeed());
  runWell(job("a", 90));
  std::istringstream words(job("b", 90));
  const std::vector<std::string> arguments{std::istream_iterator<std::string>(words),
                                           {}};
  killAgainAndAgain(arguments, output("b"), kills(), random);
  runWell(job("b", 90) + " --resume");
  expectSame("a", "b");
  EXPECT_FALSE(fs::exists(output("b") + ".fragments"));
}

INSTANTIATE_TEST_SUITE_P(
    Jobs,
    FragmentFaultsTest,
    testing::Values(FaultyJob{"powerlines", "out", {"classified.laz", "wires.geojson"}},
                    FaultyJob{"curves", "out.obj", {}}),
    [](const auto& info) { return std::string(info.param.command); });

} // namespace linelet::test
