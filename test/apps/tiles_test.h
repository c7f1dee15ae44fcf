// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>

#include "run_tool.h"

namespace linelet::test {

namespace fs = std::filesystem;

/** \brief A test on a corridor as one file and as tiles. */
class TilesTest : public ToolTest {
protected:
  /** A simulated corridor of some 80,000 points, as one file and as four tiles. */
  void
  SetUp() override
  {
    const std::string whole = std::string(LINELET_SOURCE_DIR) + "/data/corridor.las";
    runWell("convert " + whole + " " + path("whole.laz"));
    runWell("info " + whole + " --json " + path("info.json"));
    const auto bounds = json(path("info.json"))["bounds"];
    const double x0 = bounds["minimum"][0], x1 = bounds["maximum"][0],
                 y0 = bounds["minimum"][1], y1 = bounds["maximum"][1];
    fs::create_directories(path("tiles"));
    for (int i = 0; i < 4; ++i) {
      // Borders between the millimeters of the points, so that each point is in one
      // tile.
      const double side = (x1 - x0) / 4;
      const double from = std::floor((x0 + side * i) * 100) / 100 + 0.00031,
                   to = std::floor((x0 + side * (i + 1)) * 100) / 100 + 0.00031;
      char text[200];
      std::snprintf(text,
                    sizeof(text),
                    " --bounds %.6f,%.6f,%.6f,%.6f",
                    i == 0 ? x0 - 1 : from,
                    y0 - 1,
                    i == 3 ? x1 + 1 : to,
                    y1 + 1);
      runWell("convert " + whole + " " + tile(i) + text);
    }
  }

  std::string
  tile(int number) const
  {
    return path("tiles/t" + std::to_string(number) + ".laz");
  }

  /** All files of a folder, by name. */
  static std::string
  folderContents(const std::string& folder)
  {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
      files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::string all;
    for (const fs::path& file : files)
      all += file.filename().string() + '\n' + contents(file.string());
    return all;
  }

  /** Starts the tool. \return its process id */
  static pid_t
  start(const std::vector<std::string>& arguments)
  {
    const pid_t child = ::fork();
    if (child != 0)
      return child;
    const int null = ::open("/dev/null", O_WRONLY);
    ::dup2(null, 1);
    ::dup2(null, 2);
    std::vector<char*> texts = {const_cast<char*>(LINELET_TOOL)};
    for (const std::string& argument : arguments)
      texts.push_back(const_cast<char*>(argument.c_str()));
    texts.push_back(nullptr);
    ::execv(LINELET_TOOL, texts.data());
    ::_exit(127);
  }

  static int
  waitFor(pid_t child)
  {
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
  }

  /** Number of fragments, inputs and outputs done in the run for \a result. */
  static std::size_t
  doneOf(const std::string& result)
  {
    std::size_t count = 0;
    for (const char* kind : {"cut", "task", "output"}) {
      std::error_code none;
      for (const auto& entry :
           fs::directory_iterator(fs::path(result + ".fragments") / kind, none))
        count += entry.path().extension() == ".json" ? 1 : 0;
    }
    return count;
  }

  static bool
  isOver(pid_t child)
  {
    siginfo_t state{};
    return ::waitid(
               P_PID, static_cast<id_t>(child), &state, WEXITED | WNOHANG | WNOWAIT) ==
               0 &&
           state.si_pid == child;
  }

  /** Waits until \a child has cut the tiles and computed a fragment of the run for
   * \a result, or has ended; on a busy machine, starting a program alone may take
   * long. */
  static void
  waitForWork(pid_t child, const std::string& result)
  {
    while (!isOver(child) && doneOf(result) <= 4)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  /** How often a run is killed: a few times, or as set in the environment. */
  static int
  kills()
  {
    const char* asked = std::getenv("LINELET_TEST_KILLS");
    return asked != nullptr ? std::max(1, std::atoi(asked)) : 8;
  }

  /** Starts \a arguments until they have been killed that many times, each run but the
   * first with --resume. Each is killed a moment after up to five more things are done,
   * however long that takes; once all is done, \a result is removed and everything
   * starts over. */
  static void
  killAgainAndAgain(std::vector<std::string> arguments,
                    const std::string& result,
                    int times,
                    std::mt19937& random)
  {
    std::uniform_int_distribution<std::size_t> more(0, 5);
    std::uniform_int_distribution<int> moment(0, 30000); // microseconds
    for (int killed = 0, runs = 0; killed < times; ++runs) {
      ASSERT_LT(runs, 20 * times) << "nearly all were done before they were killed";
      const std::size_t until = doneOf(result) + more(random);
      const pid_t child = start(arguments);
      while (!isOver(child) && doneOf(result) < until)
        std::this_thread::sleep_for(std::chrono::microseconds(500));
      std::this_thread::sleep_for(std::chrono::microseconds(moment(random)));
      ::kill(child, SIGKILL);
      const int status = waitFor(child);
      if (WIFSIGNALED(status))
        ++killed;
      else {
        EXPECT_EQ(WEXITSTATUS(status), 0);
        fs::remove_all(result);
      }
      if (runs == 0)
        arguments.emplace_back("--resume");
    }
  }
};

} // namespace linelet::test
