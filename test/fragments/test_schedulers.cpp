// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Expected values: tables worked by hand, the optimum by trying everything, and a
// simulation of the published table of Grasso et al. 2015.

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include <linelet/fragments/dispatcher.h>
#include <linelet/fragments/gantt.h>

#include "random_seed.h"

namespace linelet::fragments {

namespace {

ExpectedTimes
tableOf(const std::vector<std::vector<double>>& rows)
{
  ExpectedTimes times(rows.size(), rows.front().size());
  for (std::size_t f = 0; f < rows.size(); ++f)
    for (std::size_t d = 0; d < rows[f].size(); ++d)
      times(f, d) = rows[f][d];
  return times;
}

const Heuristic all[] = {Heuristic::MinMin,
                         Heuristic::MaxMin,
                         Heuristic::Sufferage,
                         Heuristic::SimpleH,
                         Heuristic::SimpleHS};

/** Every fragment once, for as long as the table says, in sequence. */
void
expectWhole(const Schedule& schedule, const ExpectedTimes& times)
{
  std::set<std::size_t> seen;
  std::vector<double> load(times.devices(), 0.0);
  for (const Assignment& a : schedule) {
    EXPECT_TRUE(seen.insert(a.fragment).second) << "twice: " << a.fragment;
    EXPECT_EQ(a.begin, load[a.device]) << "a device computes two at once, or rests";
    EXPECT_EQ(a.end, a.begin + times(a.fragment, a.device));
    load[a.device] = a.end;
  }
  EXPECT_EQ(seen.size(), times.fragments());
}

double
optimum(const ExpectedTimes& times, std::vector<double>& load, std::size_t fragment = 0)
{
  if (fragment == times.fragments())
    return *std::max_element(load.begin(), load.end());
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t d = 0; d < times.devices(); ++d) {
    load[d] += times(fragment, d);
    best = std::min(best, optimum(times, load, fragment + 1));
    load[d] -= times(fragment, d);
  }
  return best;
}

std::vector<double>
ones(std::size_t count)
{
  return std::vector<double>(count, 1.0);
}

} // namespace

TEST(Schedulers, AnEmptyTableTakesNoTime)
{
  for (const Heuristic heuristic : all) {
    EXPECT_EQ(makespan(simulate(heuristic, ExpectedTimes(0, 3), {})), 0);
    const ExpectedTimes one = tableOf({{2, 1, 3}});
    const Schedule schedule = simulate(heuristic, one, {10});
    expectWhole(schedule, one);
  }
}

TEST(Schedulers, InvalidTimesAreRefused)
{
  EXPECT_THROW(minMin(tableOf({{1, -1}})), std::invalid_argument);
  EXPECT_THROW(sufferage(tableOf({{1, std::nan("")}})), std::invalid_argument);
  EXPECT_THROW(simulate(Heuristic::SimpleH, tableOf({{1, 1}}), {}),
               std::invalid_argument);
}

// Worked by hand. Fragments A(1,4) B(2,3) C(5,6) on two devices.
TEST(Schedulers, HandWorkedTable)
{
  const ExpectedTimes times = tableOf({{1, 4}, {2, 3}, {5, 6}});
  // A on 0 (1); then B: 3 on 0 or 3 on 1: first device; then C: 8 or 6: device 1.
  const Schedule least = minMin(times);
  EXPECT_EQ(least[0].fragment, 0u);
  EXPECT_EQ(least[1].fragment, 1u);
  EXPECT_EQ(least[1].device, 0u);
  EXPECT_EQ(least[2].device, 1u);
  EXPECT_EQ(makespan(least), 6);
  // C on 0 (5); then A: 6 or 4, B: 7 or 3: largest least is A, on 1 (4); B: 7 on both.
  const Schedule most = maxMin(times);
  EXPECT_EQ(most[0].fragment, 2u);
  EXPECT_EQ(most[1].fragment, 0u);
  EXPECT_EQ(most[1].device, 1u);
  EXPECT_EQ(makespan(most), 7);
  // A suffers 3, B 1, C 1: A on 0 (1). B: 3 or 3, suffers 0; C: 6 or 6, suffers 0, but
  // is longer: on 0 (6). B: 8 or 3: on 1.
  const Schedule suffering = sufferage(times);
  EXPECT_EQ(suffering[0].fragment, 0u);
  EXPECT_EQ(suffering[1].fragment, 2u);
  EXPECT_EQ(makespan(suffering), 6);
}

// With one slow device the small ones go there, the large ones elsewhere.
TEST(Schedulers, SimpleHTakesBothEnds)
{
  const ExpectedTimes times = tableOf({{30, 3}, {10, 1}, {20, 2}, {40, 4}});
  const Schedule schedule = simulate(Heuristic::SimpleH, times, {3, 1, 2, 4});
  ASSERT_EQ(schedule.size(), 4u);
  EXPECT_EQ(schedule[0].device, 0u);
  EXPECT_EQ(schedule[0].fragment, 1u); // smallest to the slow one
  EXPECT_EQ(schedule[1].fragment, 3u); // largest to the fast one
  EXPECT_EQ(schedule[2].fragment, 0u);
  EXPECT_EQ(schedule[3].fragment, 2u);
  EXPECT_EQ(makespan(schedule), 10);
}

TEST(Schedulers, SimpleHSStopsTheSlowDeviceInTime)
{
  // At 10 the slow device is free, and 3 is left: it would end at 40, elsewhere at 14.
  const std::vector<double> points = {1, 3, 3, 4, 4};
  std::vector<std::vector<double>> rows;
  for (const double n : points)
    rows.push_back({10 * n, n});
  const ExpectedTimes times = tableOf(rows);
  EXPECT_EQ(makespan(simulate(Heuristic::SimpleH, times, points)), 40);
  EXPECT_EQ(makespan(simulate(Heuristic::SimpleHS, times, points)), 14);
}

// SimpleHS predicts with a quadratic, which is exact where the times are one.
TEST(Schedulers, PredictionIsTheQuadraticOfTheTimes)
{
  TimePrediction predicted;
  EXPECT_FALSE(predicted.known());
  const auto truth = [](double n) { return 0.5 + 2e-6 * n + 3e-13 * n * n; };
  predicted.add(1e6, 4);
  EXPECT_DOUBLE_EQ(predicted(5e5), 2); // a rate
  TimePrediction exact;
  for (const double n : {1e3, 5e5, 2e6, 3.5e6})
    exact.add(n, truth(n));
  for (const double n : {1e4, 1e6, 3e6})
    EXPECT_NEAR(exact(n), truth(n), 1e-9);
  EXPECT_GE(exact(-1e9), 0);
}

// Up to 8 fragments on 3 devices: never below the optimum, never above the theorem's
// bound.
TEST(Schedulers, WithinTheBoundOfTheOptimum)
{
  const unsigned seed = test::randomSeed();
  std::mt19937 random(seed);
  std::lognormal_distribution<double> size(0, 1);
  std::uniform_real_distribution<double> speed(1, 12);
  double excess[5] = {};
  constexpr int runs = 200;
  for (int run = 0; run < runs; ++run) {
    ExpectedTimes times(1 + random() % 8, 3);
    std::vector<double> points;
    const double speeds[3] = {1, speed(random), speed(random)};
    for (std::size_t f = 0; f < times.fragments(); ++f) {
      points.push_back(size(random));
      for (std::size_t d = 0; d < 3; ++d)
        times(f, d) = points[f] / speeds[d];
    }
    std::vector<double> load(3, 0.0);
    const double best = optimum(times, load);
    for (std::size_t h = 0; h < 5; ++h) {
      const Schedule schedule = simulate(all[h], times, points);
      expectWhole(schedule, times);
      const double end = makespan(schedule);
      EXPECT_GE(end, best * (1 - 1e-12));
      if (h < 3) {
        EXPECT_LE(end, 3 * best * (1 + 1e-12));
      }
      excess[h] += end / best / runs;
    }
  }
  // Much closer on average (1.05 to 1.3 when this was written).
  EXPECT_LT(excess[1], 1.15) << "Max-Min";
  EXPECT_LT(excess[2], 1.15) << "Sufferage";
}

namespace {

/** 65 fragments of 1 thousand to 3.5 million points, 58 million in total. */
std::vector<double>
lidarFragments(std::mt19937& random)
{
  // n = 3.5e6 u^p has the mean 58e6 / 65 for p = 2.92.
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<double> points;
  for (int i = 0; i < 65; ++i)
    points.push_back(1e3 + 3.499e6 * std::pow(u(random), 2.92));
  return points;
}

/** The shares of Sufferage's speed that a heuristic reaches in 4,000 simulations,
 * sorted. */
std::vector<double>
sharesOfSufferage(Heuristic heuristic, double slow, double fast, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<double> shares;
  for (int run = 0; run < 4000; ++run) {
    const std::vector<double> points = lidarFragments(random);
    ExpectedTimes times(points.size(), 3);
    for (std::size_t f = 0; f < points.size(); ++f) {
      times(f, 0) = points[f] / slow;
      times(f, 1) = times(f, 2) = points[f] / fast;
    }
    shares.push_back(makespan(sufferage(times)) /
                     makespan(simulate(heuristic, times, points)));
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

} // namespace

// Table 2 of the paper: a CPU and two GPUs 12 times as fast (mc1), and 4.5 beside 23.8
// (mc2). The paper gives only number and range of its one set of 65 fragments: its
// figures lie, to 1.5 %, within those of 96 of 100 such sets.
TEST(Schedulers, PublishedTable)
{
  const unsigned seed = test::randomSeed();
  struct Machine {
    double slow, fast, printed[4];
  };
  const Heuristic compared[] = {
      Heuristic::MinMin, Heuristic::MaxMin, Heuristic::SimpleH, Heuristic::SimpleHS};
  for (const Machine& machine : {Machine{1, 12, {.9190, .9980, .9758, .9879}},
                                 Machine{4.5, 23.8, {.9073, .9991, .9545, .9545}}})
    for (std::size_t h = 0; h < 4; ++h) {
      const auto shares =
          sharesOfSufferage(compared[h], machine.slow, machine.fast, seed);
      EXPECT_GE(machine.printed[h], shares[80] - .015) << h;
      EXPECT_LE(machine.printed[h], shares[3919] + .015) << h;
    }
}

TEST(Schedulers, SimpleHSIsBetterThanSimpleHOnAverage)
{
  const unsigned seed = test::randomSeed();
  const auto mean = [&](Heuristic heuristic) {
    double sum = 0;
    for (const double share : sharesOfSufferage(heuristic, 1, 12, seed))
      sum += share / 4000;
    return sum;
  };
  EXPECT_GT(mean(Heuristic::SimpleHS), mean(Heuristic::SimpleH) + .02);
  EXPECT_GT(mean(Heuristic::SimpleHS), mean(Heuristic::MinMin) + .02);
}

// The source crashed at 3,000 fragments and more.
TEST(Schedulers, ThousandsOfTinyFragments)
{
  ExpectedTimes times(5000, 3);
  for (std::size_t f = 0; f < 5000; ++f)
    for (std::size_t d = 0; d < 3; ++d)
      times(f, d) = 1.0 / static_cast<double>(d + 1);
  for (const Heuristic heuristic : all)
    expectWhole(simulate(heuristic, times, ones(5000)), times);
}

// A cluster of one.
TEST(Schedulers, OneDeviceComputesAll)
{
  ExpectedTimes times(20, 1);
  for (std::size_t f = 0; f < 20; ++f)
    times(f, 0) = static_cast<double>(f);
  for (const Heuristic heuristic : all)
    expectWhole(simulate(heuristic, times, ones(20)), times);
}

TEST(Schedulers, ChartHasABarForEveryFragment)
{
  const ExpectedTimes times = tableOf({{1, 4}, {2, 3}, {5, 6}});
  const std::string svg = ganttChart({{"a<b", sufferage(times)}}, {"cpu & co", "gpu"});
  std::size_t bars = 0;
  for (std::size_t at = 0; (at = svg.find("<title>", at)) != std::string::npos; ++at)
    ++bars;
  EXPECT_EQ(bars, 3u);
  EXPECT_NE(svg.find("a&lt;b"), std::string::npos);
  EXPECT_NE(svg.find("cpu &amp; co"), std::string::npos);
}

} // namespace linelet::fragments
