// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Each fragment is computed once and settled once, whichever device it goes to and
// whatever fails.

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include <linelet/fragments/executor.h>

namespace linelet::fragments {

namespace {

Fragment
fragmentOf(std::size_t number)
{
  Fragment fragment;
  fragment.number = number;
  return fragment;
}

/** What became of the fragments. */
class Record {
public:
  FragmentWork
  work()
  {
    return {fragmentOf,
            [this](const Fragment& fragment, std::size_t number, std::size_t device) {
              const std::lock_guard<std::mutex> lock(mutex_);
              EXPECT_EQ(fragment.number, number) << "points of another fragment";
              ++computed[number];
              ++by_device[device];
            },
            [this](std::size_t number, const std::string& reason) {
              // No lock: calls are promised to come one at a time.
              EXPECT_TRUE(settled.emplace(number, reason).second) << number;
            }};
  }

  std::map<std::size_t, int> computed, by_device;
  std::map<std::size_t, std::string> settled;

private:
  std::mutex mutex_;
};

Dispatcher
inOrder(std::size_t count)
{
  Schedule schedule;
  for (std::size_t k = 0; k < count; ++k)
    schedule.push_back({k, 0, 0, 0});
  return {schedule, 1};
}

} // namespace

class ExecutorTest : public testing::TestWithParam<Heuristic> {};

// The crash of the source: thousands of fragments that take no time.
TEST_P(ExecutorTest, ThousandsOfTinyFragmentsOnceEach)
{
  constexpr std::size_t count = 5000;
  std::vector<double> points(count);
  std::iota(points.begin(), points.end(), 1.0);
  ExpectedTimes times(count, 3);
  for (std::size_t f = 0; f < count; ++f)
    for (std::size_t d = 0; d < 3; ++d)
      times(f, d) = 1e-6 * points[f] * static_cast<double>(d + 1);
  Dispatcher dispatcher = dispatcherFor(GetParam(), times, points);
  Record record;
  execute(dispatcher, 3, record.work());
  EXPECT_EQ(record.settled.size(), count);
  EXPECT_EQ(record.computed.size(), count);
  for (const auto& [fragment, number] : record.computed)
    EXPECT_EQ(number, 1) << fragment;
  for (const auto& [fragment, reason] : record.settled)
    EXPECT_EQ(reason, "") << fragment;
}

INSTANTIATE_TEST_SUITE_P(Heuristics,
                         ExecutorTest,
                         testing::Values(Heuristic::MinMin,
                                         Heuristic::MaxMin,
                                         Heuristic::Sufferage,
                                         Heuristic::SimpleH,
                                         Heuristic::SimpleHS),
                         [](const auto& info) {
                           std::string name(nameOf(info.param));
                           name.erase(std::remove(name.begin(), name.end(), '-'),
                                      name.end());
                           return name;
                         });

// While a device computes a fragment, it loads the next one: here, none finishes before
// the next one has been requested.
TEST(Executor, LoadsTheNextFragmentMeanwhile)
{
  constexpr std::size_t count = 20;
  std::mutex mutex;
  std::condition_variable changed;
  std::size_t loaded = 0;
  FragmentWork work;
  work.load = [&](std::size_t number) {
    const std::lock_guard<std::mutex> lock(mutex);
    ++loaded;
    changed.notify_all();
    return fragmentOf(number);
  };
  work.compute = [&](const Fragment&, std::size_t number, std::size_t) {
    std::unique_lock<std::mutex> lock(mutex);
    EXPECT_TRUE(changed.wait_for(lock,
                                 std::chrono::seconds(20),
                                 [&] { return loaded >= std::min(count, number + 2); }))
        << "fragment " << number;
    EXPECT_LE(loaded, number + 2) << "no more than one ahead";
  };
  std::size_t settled = 0;
  work.settle = [&](std::size_t number, const std::string&) {
    EXPECT_EQ(number, settled++) << "one device keeps the order";
  };
  Dispatcher dispatcher = inOrder(count);
  execute(dispatcher, 1, work);
  EXPECT_EQ(settled, count);
}

// Two devices work at the same time: each waits for the other.
TEST(Executor, DevicesWorkSideBySide)
{
  std::mutex mutex;
  std::condition_variable changed;
  std::set<std::size_t> busy;
  Record record;
  FragmentWork work = record.work();
  work.compute = [&](const Fragment&, std::size_t, std::size_t device) {
    std::unique_lock<std::mutex> lock(mutex);
    busy.insert(device);
    changed.notify_all();
    EXPECT_TRUE(changed.wait_for(
        lock, std::chrono::seconds(20), [&] { return busy.size() == 2; }));
  };
  Dispatcher dispatcher(Heuristic::SimpleH, {1, 2, 3, 4}, 2, 1);
  execute(dispatcher, 2, work);
  EXPECT_EQ(record.settled.size(), 4U);
}

TEST(Executor, WhatFailsIsTriedOnceMoreOnTheFirstDevice)
{
  std::map<std::size_t, std::vector<std::size_t>> tries;
  std::mutex mutex;
  Record record;
  FragmentWork work = record.work();
  work.compute = [&](const Fragment& fragment, std::size_t number, std::size_t device) {
    EXPECT_EQ(fragment.number, number);
    const std::lock_guard<std::mutex> lock(mutex);
    tries[number].push_back(device);
    if (device == 1 || number == 3)
      throw std::runtime_error("no " + std::to_string(number));
  };
  Schedule schedule;
  for (std::size_t k = 0; k < 8; ++k)
    schedule.push_back({k, k % 2, 0, 0});
  Dispatcher dispatcher(schedule, 2);
  execute(dispatcher, 2, work);
  ASSERT_EQ(record.settled.size(), 8U);
  for (const auto& [number, reason] : record.settled) {
    EXPECT_EQ(reason, number == 3 ? "no 3" : "") << number;
    const std::vector<std::size_t> expected =
        number % 2 == 1 ? std::vector<std::size_t>{1, 0} : std::vector<std::size_t>{0};
    EXPECT_EQ(tries[number], expected) << number;
  }
}

// On a single device, a failed fragment is retried next, before the one loaded
// meanwhile.
TEST(Executor, AFailureDoesNotShiftTheOthers)
{
  Record record;
  FragmentWork work = record.work();
  const auto compute = work.compute;
  std::set<std::size_t> failed;
  work.compute = [&](Fragment& fragment, std::size_t number, std::size_t device) {
    if (failed.insert(number).second)
      throw std::runtime_error("at first");
    compute(fragment, number, device);
  };
  std::set<std::size_t> unreadable;
  work.load = [&](std::size_t number) {
    if (number == 5 || (number == 7 && unreadable.insert(number).second))
      throw std::runtime_error("unreadable");
    return fragmentOf(number);
  };
  Dispatcher dispatcher = inOrder(10);
  execute(dispatcher, 1, work);
  ASSERT_EQ(record.settled.size(), 10U);
  for (const auto& [number, reason] : record.settled)
    EXPECT_EQ(reason,
              number == 5   ? "unreadable"
              : number == 7 ? "at first" // its second try
                            : "")
        << number;
  EXPECT_EQ(record.computed.size(), 8U);
}

TEST(Executor, EndsWhenCanceledOrWhenNothingCanBeNoted)
{
  for (const bool canceled : {true, false}) {
    Record record;
    FragmentWork work = record.work();
    if (canceled)
      work.compute = [](const Fragment&, std::size_t number, std::size_t) {
        if (number == 3)
          throw Canceled();
      };
    else
      work.settle = [](std::size_t number, const std::string&) {
        if (number == 3)
          throw std::runtime_error("disk full");
      };
    std::vector<double> points(50, 1.0);
    Dispatcher dispatcher(Heuristic::SimpleH, points, 3, 2);
    if (canceled)
      EXPECT_THROW(execute(dispatcher, 3, work), Canceled);
    else
      EXPECT_THROW(execute(dispatcher, 3, work), std::runtime_error);
  }
}

TEST(Executor, NothingToDo)
{
  Record record;
  Dispatcher none = inOrder(0);
  execute(none, 1, record.work());
  Dispatcher few(Heuristic::SimpleHS, {1}, 3, 2);
  execute(few, 3, record.work());
  EXPECT_EQ(record.settled.size(), 1U);
}

} // namespace linelet::fragments
