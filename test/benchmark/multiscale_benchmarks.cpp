// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchmarks.h"

#include <algorithm>
#include <string>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <benchmark/benchmark.h>

#include <linelet/features/grid_tensor_engine.h>
#include <linelet/features/multi_scale.h>

#include "scenes.h"

namespace linelet::benchmarking {

namespace {

constexpr std::size_t point_count = 20000;

/** \brief A wire: one point a unit of length, off it by up to 0.1 a coordinate. */
const Points&
line()
{
  static const Points points = [] {
    boost::random::mt19937 random(1);
    boost::random::uniform_real_distribution<double> along(0, point_count),
        beside(-0.1, 0.1);
    Points made;
    for (std::size_t i = 0; i < point_count; ++i) {
      const double x = along(random), y = beside(random), z = beside(random);
      made.emplace_back(x, y, z);
    }
    return made;
  }();
  return points;
}

/** \brief Lowers \a best to the CPU seconds of \a work. */
template <class Work>
double
timed(double& best, const Work& work)
{
  const double start = cpuSeconds();
  work();
  const double seconds = cpuSeconds() - start;
  best = std::min(best, seconds);
  return seconds;
}

void
cost(benchmark::State& state, bool is_line, const char* kernel, Centroid centroid)
{
  const Points& points =
      is_line ? line() : scene(Scene::Surface, point_count, Order::Shuffled);
  MultiScaleSettings ladder;
  ladder.weighting = Weighting(kernel);
  ladder.centroid = centroid;
  ladder.threads = 1;
  ladder.engine = ScaleEngine::Sweep;
  MultiScaleSettings on_grid = ladder;
  on_grid.engine = ScaleEngine::Grid;

  const MultiScaleShapes scales = multiScaleRadii(points, ladder);
  MultiScaleSettings single = ladder;
  single.radii = {scales.radii.back()};
  single.scale_unit = scales.scale_unit; // one radius needs no D
  TensorSettings pass;
  pass.radius = scales.radii.back();
  pass.weighting = ladder.weighting;
  pass.centroid = centroid;
  pass.threads = 1;

  double all = 1e9, all_grid = 1e9, one_sweep = 1e9, one_grid = 1e9, neighbours = 0;
  const auto shapes = [&](const MultiScaleSettings& settings) {
    return
        [&] { benchmark::DoNotOptimize(multiScaleShapes(points, points, settings)); };
  };
  for (auto _ : state) {
    state.SetIterationTime(timed(all, shapes(ladder)));
    timed(one_sweep, shapes(single));
    timed(one_grid, [&] {
      neighbours = 0;
      for (const auto& record : estimateTensorsOnGrid(points, points, pass))
        neighbours += record.neighbors;
    });
    timed(all_grid, shapes(on_grid));
  }
  state.counters["scales"] = static_cast<double>(scales.radii.size());
  state.counters["neighbours"] = neighbours / point_count;
  state.counters["x_one_pass_sweep"] = all / one_sweep;
  state.counters["x_one_pass_grid"] = all_grid / one_grid;
  state.counters["x_sweep"] = all / all_grid;
}

} // namespace

void
addMultiScaleBenchmarks()
{
  for (const bool is_line : {true, false})
    for (const char* kernel : {"const", "fermi-dirac-1"})
      for (const auto& [centroid, name] : Names<Centroid>::table) {
        const std::string title = std::string("multiscale-cost/") +
                                  (is_line ? "line/" : "plane/") + kernel + "/" +
                                  std::string(name);
        benchmark::RegisterBenchmark(
            title.c_str(),
            [is_line, kernel, type = centroid](benchmark::State& state) {
              cost(state, is_line, kernel, type);
            })
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond)
            ->Iterations(3);
      }
}

} // namespace linelet::benchmarking
