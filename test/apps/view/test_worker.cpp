// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "model/worker.h"

namespace {

using namespace linelet;
using namespace linelet::view;

std::string
finish(Worker& worker)
{
  std::string error;
  while (worker.busy() && !worker.poll(error))
    std::this_thread::yield();
  return error;
}

TEST(Worker, WorkIsTakenOverOnce)
{
  Worker worker;
  int worked = 0, taken = 0; // no lock: poll orders them
  worker.start([&](ProgressMonitor*) { ++worked; }, [&] { ++taken; });
  EXPECT_EQ(finish(worker), "");
  EXPECT_EQ(worked, 1);
  EXPECT_EQ(taken, 1);
  std::string error;
  EXPECT_FALSE(worker.poll(error));
}

TEST(Worker, CanceledWorkIsNotTakenOver)
{
  Worker worker;
  bool taken = false;
  std::atomic<bool> begun{false};
  worker.start(
      [&](ProgressMonitor* monitor) {
        begun = true;
        while (true)
          throwIfCanceled(monitor);
      },
      [&] { taken = true; });
  while (!begun)
    std::this_thread::yield();
  worker.cancel();
  EXPECT_EQ(finish(worker), "");
  EXPECT_FALSE(taken);
}

// Work that is canceled too late: its result is discarded.
TEST(Worker, LateResultsAreDropped)
{
  Worker worker;
  int taken = 0;
  worker.start([](ProgressMonitor*) {}, [&] { taken += 1; });
  worker.start([](ProgressMonitor*) {}, [&] { taken += 10; });
  finish(worker);
  EXPECT_EQ(taken, 10);
}

TEST(Worker, FailuresAreReported)
{
  Worker worker;
  worker.start([](ProgressMonitor*) { throw std::runtime_error("no such thing"); }, {});
  EXPECT_EQ(finish(worker), "no such thing");
}

TEST(Worker, ProgressIsSeenFromOutside)
{
  Worker worker;
  std::atomic<bool> half{false}, go{false};
  worker.start(
      [&](ProgressMonitor* monitor) {
        monitor->begin("counting", 10);
        for (int i = 0; i < 5; ++i)
          monitor->advance(1);
        half = true;
        while (!go)
          std::this_thread::yield();
      },
      {});
  while (!half)
    std::this_thread::yield();
  EXPECT_EQ(worker.progress().stage, "counting");
  EXPECT_DOUBLE_EQ(worker.progress().part, 0.5);
  go = true;
  finish(worker);
}

// A window closed while work is running.
TEST(Worker, EndsWithItsOwner)
{
  std::atomic<bool> stopped{false};
  {
    Worker worker;
    worker.start(
        [&](ProgressMonitor* monitor) {
          while (!monitor->canceled())
            std::this_thread::yield();
          stopped = true;
        },
        {});
  }
  EXPECT_TRUE(stopped);
}

} // namespace
