// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchmarks.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <string>

#include <malloc.h>

#include <benchmark/benchmark.h>
#include <hwy/targets.h>

#include <linelet/features/grid_tensor_engine.h>
#include <linelet/features/multi_scale.h>

#include "features/simd_grid/kernels/sweep_kernels.h"
#include "rivals.h"
#include "scenes.h"

namespace linelet::benchmarking {

namespace {

struct Case {
  Scene scene = Scene::Volume;
  std::size_t points = 200000;
  double neighbors = 100;
  const char* weight = "const";
  unsigned threads = 1;
  Order order = Order::Shuffled;
};

/** \brief Pairs per second of the inner loop on a list that stays in the cache: the
 * limit set by the arithmetic. */
double
peak(const Weighting& weighting)
{
  constexpr std::size_t entries = 1024, repeats = 4000;
  grid::PointList list;
  list.reserve(entries);
  list.size = entries;
  for (std::size_t i = 0; i < entries; ++i) {
    list.x[i] = 0.3F + static_cast<float>(i % 10) / 50; // all neighbors, none near
    list.y[i] = 0.3F + static_cast<float>(i % 11) / 50;
    list.z[i] = 0.3F + static_cast<float>(i % 12) / 50;
    list.h[i] = list.x[i] * list.x[i] + list.y[i] * list.y[i] + list.z[i] * list.z[i];
  }
  list.pad();
  const grid::SweepKernels kernels = grid::sweepKernels();
  const grid::SweepWeight weight(weighting);
  grid::PointList none;
  none.reserve(0);
  none.pad();
  const grid::BandedQuery query{{0.1F, 0.1F, 0.1F}, {1, 1}};
  const grid::WeightedLists lists = {none, query, list, query.at};
  double best = 1e9;
  for (int turn = 0; turn < 5; ++turn) {
    const double start = cpuSeconds();
    grid::Moments sums;
    for (std::size_t i = 0; i < repeats; ++i)
      if (weighting.kernel() == Kernel::Const)
        kernels.constSums(list, &query, 1, &sums);
      else
        kernels.weightedSums(lists, weight, 1, sums);
    benchmark::DoNotOptimize(sums);
    best = std::min(best, cpuSeconds() - start);
  }
  return static_cast<double>(entries * repeats) / best;
}

void
tensor(benchmark::State& state, const Case& c)
{
  const Points& points = scene(c.scene, c.points, c.order);
  TensorSettings settings;
  settings.radius = radiusFor(c.scene, c.neighbors);
  settings.weighting = Weighting(c.weight);
  settings.threads = c.threads;
  const auto n = static_cast<double>(c.points);

  // The rival runs before and after, and its better time counts: the machine may be
  // busy.
  const auto sample =
      static_cast<std::size_t>(std::min(n / 4, std::max(2000.0, 4e6 / c.neighbors)));
  const auto rival = [&] {
    const RivalTime time = pclNormals(points, settings.radius, c.threads, sample);
    return time.query + time.build / n;
  };
  double pcl = rival();
  double best = 1e9;
  std::vector<PointDistributionTensor> records;
  for (auto _ : state) {
    const double start = seconds(c.threads);
    records = estimateTensorsOnGrid(points, points, settings);
    const double time = seconds(c.threads) - start;
    state.SetIterationTime(time);
    best = std::min(best, time);
  }
  pcl = std::min(pcl, rival());
  double pairs = 0;
  for (const PointDistributionTensor& record : records)
    pairs += record.neighbors;
  state.counters["neighbors"] = pairs / n;
  state.counters["us_per_point"] = best / n * 1e6;
  state.counters["x_pcl"] = pcl / (best / n);
  state.counters["Gpairs/s"] = pairs / best * 1e-9;
  state.counters["of_peak"] = pairs / best / peak(settings.weighting);
}

/** \brief The same as \ref tensor with an instruction set other than the machine's
 * best. */
void
tensorOn(benchmark::State& state, const Case& c, std::int64_t instruction_set)
{
  hwy::SetSupportedTargetsForTest(instruction_set);
  tensor(state, c);
  hwy::SetSupportedTargetsForTest(0);
}

/** \brief Resident bytes by name in /proc/self/status. */
double
resident(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == name) {
      double kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  return 0;
}

/** \brief Time and memory per point as the cloud grows at constant density. */
void
growth(benchmark::State& state, const Case& c)
{
  const Points& points = scene(c.scene, c.points, c.order);
  TensorSettings settings;
  settings.radius = radiusFor(c.scene, c.neighbors);
  settings.weighting = Weighting(c.weight);
  settings.threads = c.threads;
  const auto n = static_cast<double>(c.points);
  double best = 1e9, bytes = 0;
  for (auto _ : state) {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5"; // resets the high-water mark
    const double before = resident("VmRSS:");
    const double start = cpuSeconds();
    const auto records = estimateTensorsOnGrid(points, points, settings);
    const double seconds = cpuSeconds() - start;
    state.SetIterationTime(seconds);
    best = std::min(best, seconds);
    bytes = resident("VmHWM:") - before -
            n * static_cast<double>(sizeof(PointDistributionTensor));
  }
  static std::map<Scene, double> firsts; // of the smallest cloud of each scene
  const double first = firsts.emplace(c.scene, best / n).first->second;
  state.counters["us_per_point"] = best / n * 1e6;
  state.counters["x_first"] = best / n / first;
  state.counters["bytes_per_point"] = bytes / n;
}

void
multiScale(benchmark::State& state, const Case& c)
{
  const Points& points = scene(c.scene, c.points, c.order);
  MultiScaleSettings settings;
  settings.weighting = Weighting(c.weight);
  settings.threads = c.threads;
  const double largest = radiusFor(c.scene, c.neighbors);
  double pcl = 0;
  for (double radius = largest; settings.radii.size() < 8; radius /= 1.5)
    settings.radii.insert(settings.radii.begin(), radius);
  const auto n = static_cast<double>(c.points);
  for (const double radius : settings.radii)
    pcl += pclNormals(points, radius, c.threads, 2000).query;
  double best = 1e9;
  for (auto _ : state) {
    const double start = cpuSeconds();
    benchmark::DoNotOptimize(multiScaleShapes(points, points, settings));
    const double seconds = cpuSeconds() - start;
    state.SetIterationTime(seconds);
    best = std::min(best, seconds);
  }
  state.counters["scales"] = static_cast<double>(settings.radii.size());
  state.counters["us_per_point"] = best / n * 1e6;
  state.counters["x_pcl"] = pcl / (best / n);
}

std::string
name(const std::string& what, const Case& c)
{
  return what + (c.scene == Scene::Volume ? "/volume" : "/surface") + "/" + c.weight +
         "/neighbors:" + std::to_string(static_cast<int>(c.neighbors)) +
         "/points:" + std::to_string(c.points) +
         "/threads:" + std::to_string(c.threads) +
         (c.order == Order::Sorted ? "/sorted" : "/shuffled");
}

template <class Run>
void
add(const std::string& what, const Case& c, Run run)
{
  benchmark::RegisterBenchmark(name(what, c).c_str(),
                               [run, c](benchmark::State& state) { run(state, c); })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(3);
}

} // namespace

void
addTensorBenchmarks()
{
  for (const Scene scene : {Scene::Volume, Scene::Surface})
    for (const char* weight : {"const", "fermi-dirac-1"})
      for (const double neighbors : {10.0, 100.0, 500.0, 5000.0})
        for (const unsigned threads : {1U, 2U})
          for (const Order order : {Order::Shuffled, Order::Sorted})
            add("tensor", {scene, 200000, neighbors, weight, threads, order}, tensor);
  for (const std::int64_t set : hwy::SupportedAndGeneratedTargets())
    for (const Scene scene : {Scene::Volume, Scene::Surface})
      for (const char* weight : {"const", "fermi-dirac-1"})
        add(std::string("instructions/") + hwy::TargetName(set),
            {scene, 200000, 500, weight, 1, Order::Shuffled},
            [set](benchmark::State& state, const Case& c) { tensorOn(state, c, set); });
  for (const Scene scene : {Scene::Volume, Scene::Surface})
    for (const std::size_t points : {100000U, 1000000U, 10000000U})
      add("growth", {scene, points, 100, "const", 1, Order::Shuffled}, growth);
  for (const char* weight : {"const", "fermi-dirac-1"})
    for (const double neighbors : {100.0, 500.0})
      add("multiscale",
          {Scene::Surface, 20000, neighbors, weight, 1, Order::Shuffled},
          multiScale);
}

} // namespace linelet::benchmarking
