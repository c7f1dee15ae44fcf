// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchmarks.h"

#include <algorithm>
#include <string>

#include <benchmark/benchmark.h>

#include <linelet/opencl/tensor_engine.h>

#include "rivals.h"
#include "scenes.h"

namespace linelet::benchmarking {

namespace {

/** \brief CPU seconds per query of the kd-tree engine at some of the points, and per
 * point for building the tree. */
double
treeSeconds(const Points& points, const TensorSettings& settings)
{
  TensorSettings tree = settings;
  tree.engine = Engine::Tree;
  const Points some(points.begin(), points.begin() + 4000);
  double start = cpuSeconds();
  benchmark::DoNotOptimize(estimateTensors(points, {}, tree));
  const double build = cpuSeconds() - start;
  start = cpuSeconds();
  benchmark::DoNotOptimize(estimateTensors(points, some, tree));
  const double queries = cpuSeconds() - start - build;
  return build / static_cast<double>(points.size()) +
         queries / static_cast<double>(some.size());
}

struct DeviceCase {
  Scene scene = Scene::Volume;
  const char* weight = "const";
  double neighbors = 100;
  bool nearest = false; ///< that many nearest points instead of a radius
};

void
openCl(benchmark::State& state, const DeviceCase& c)
{
  const Points& points = scene(c.scene, 200000, Order::Shuffled);
  const double radius = radiusFor(c.scene, c.neighbors);
  TensorSettings settings;
  if (c.nearest)
    settings.k = static_cast<unsigned>(c.neighbors);
  else
    settings.radius = radius;
  settings.weighting = Weighting(c.weight);
  const auto n = static_cast<double>(points.size());
  // The rivals run before and after, and their better time counts: the machine may be
  // busy.
  double tree = 1e9, pcl = 1e9;
  const auto timeRivals = [&] {
    tree = std::min(tree, treeSeconds(points, settings));
    if (!c.nearest)
      pcl = std::min(pcl, pclNormals(points, radius, 2, 4000).query);
  };
  timeRivals();

  opencl::TensorEngine engine;
  engine.estimate(points, points, settings); // builds the kernels
  double best = 1e9, pairs = 0;
  for (auto _ : state) {
    const double start = cpuSeconds();
    const auto records = engine.estimate(points, points, settings);
    const double seconds = cpuSeconds() - start;
    state.SetIterationTime(seconds);
    best = std::min(best, seconds);
    pairs = 0;
    for (const PointDistributionTensor& record : records)
      pairs += record.neighbors;
  }
  timeRivals();
  const opencl::StageTimes& times = engine.stageTimes();
  state.SetLabel(engine.device().name);
  state.counters["neighbors"] = pairs / n;
  state.counters["us_per_point"] = best / n * 1e6;
  state.counters["x_tree"] = tree / (best / n);
  if (!c.nearest)
    state.counters["x_pcl"] = pcl / (best / n);
  state.counters["upload_ms"] = 1e3 * times.upload;
  state.counters["grid_ms"] = 1e3 * times.grid;
  if (c.nearest)
    state.counters["nearest_ms"] = 1e3 * times.nearest;
  state.counters["tensor_ms"] = 1e3 * times.tensor;
  state.counters["analysis_ms"] = 1e3 * times.analysis;
  state.counters["download_ms"] = 1e3 * times.download;
}

} // namespace

void
addOpenClBenchmarks()
{
  if (opencl::devices().empty())
    return;
  const auto add = [](const DeviceCase& c) {
    benchmark::RegisterBenchmark(
        (std::string("opencl") + (c.scene == Scene::Volume ? "/volume/" : "/surface/") +
         c.weight + (c.nearest ? "/nearest:" : "/neighbors:") +
         std::to_string(static_cast<int>(c.neighbors)) + "/points:200000/shuffled")
            .c_str(),
        [c](benchmark::State& state) { openCl(state, c); })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond)
        ->Iterations(3);
  };
  for (const Scene kind : {Scene::Volume, Scene::Surface}) {
    for (const char* weight : {"const", "fermi-dirac-1"})
      for (const double neighbors : {100.0, 500.0, 5000.0})
        add({kind, weight, neighbors, false});
    for (const double neighbors : {10.0, 100.0, 500.0})
      add({kind, "fermi-dirac-1", neighbors, true});
  }
}

} // namespace linelet::benchmarking
