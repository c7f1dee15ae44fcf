// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchmarks.h"

#include <algorithm>
#include <string>
#include <utility>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <benchmark/benchmark.h>

#include <linelet/features/grid_tensor_engine.h>
#include <linelet/features/multi_scale.h>

#include "scenes.h"

namespace linelet::benchmarking {

namespace {

constexpr std::size_t point_count = 20000;

/// Enough for a surface several largest radii wide, which its border does not cut off.
constexpr std::size_t wide_count = 200000;

/// Medians are slow, so they are measured at some points only.
constexpr std::ptrdiff_t line_medians = 3000, plane_medians = 60;

/** \brief A wire: one point per unit of length, displaced by up to 0.1 per
 * coordinate. */
Points
line()
{
  boost::random::mt19937 random(1);
  boost::random::uniform_real_distribution<double> along(0, point_count),
      beside(-0.1, 0.1);
  Points made;
  for (std::size_t i = 0; i < point_count; ++i) {
    const double x = along(random), y = beside(random), z = beside(random);
    made.emplace_back(x, y, z);
  }
  return made;
}

/** \brief Lowers \a best to the CPU time of \a work, if that is less. */
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

/** \brief A cloud of the benchmark. */
enum class Cloud { Line, Plane, WidePlane };

Points
made(Cloud cloud)
{
  if (cloud == Cloud::Line)
    return line();
  return scene(Scene::Surface,
               cloud == Cloud::Plane ? point_count : wide_count,
               Order::Shuffled);
}

/** \brief The whole sequence of radii, D measured, compared with one pass at its
 * largest radius. x_one_pass: cost relative to that pass on the grid engine, as
 * `linelet multiscale` is to `linelet tensor --radius`. x_one_scale: cost relative to a
 * multi-scale sweep of that radius alone, which looks at every pair and sums nothing by
 * blocks. x_sweep: time of the engine in double relative to the grid's. */
void
cost(benchmark::State& state, Cloud cloud, const char* kernel, Centroid centroid)
{
  const bool median =
      centroid == Centroid::Median || centroid == Centroid::WeightedMedian;
  const Points points = made(cloud);
  const Points some(points.begin(),
                    points.begin() +
                        (cloud == Cloud::Line ? line_medians : plane_medians));
  const Points& queries = median ? some : points;
  MultiScaleSettings all_scales;
  all_scales.weighting = Weighting(kernel);
  all_scales.centroid = centroid;
  all_scales.threads = 1;
  all_scales.engine = ScaleEngine::Grid;
  MultiScaleSettings sweep = all_scales;
  sweep.engine = ScaleEngine::Sweep;

  const MultiScaleShapes scales = multiScaleRadii(points, all_scales);
  MultiScaleSettings single = all_scales;
  single.radii = {scales.radii.back()};
  single.scale_unit = scales.scale_unit; // a single radius needs no D
  MultiScaleSettings given = all_scales;
  given.radii = scales.radii;
  given.scale_unit = scales.scale_unit;
  TensorSettings pass;
  pass.radius = scales.radii.back();
  pass.weighting = all_scales.weighting;
  pass.centroid = centroid;
  pass.threads = 1;

  double all = 1e9, all_given = 1e9, all_sweep = 1e9, one_scale = 1e9, one_pass = 1e9,
         neighbors = 0;
  const auto shapes = [&](const MultiScaleSettings& settings) {
    return
        [&] { benchmark::DoNotOptimize(multiScaleShapes(points, queries, settings)); };
  };
  bool first = true;
  for (auto _ : state) {
    state.SetIterationTime(timed(all, shapes(all_scales)));
    timed(all_given, shapes(given));
    timed(one_scale, shapes(single));
    timed(one_pass, [&] {
      neighbors = 0;
      for (const auto& record : estimateTensorsOnGrid(points, queries, pass))
        neighbors += record.neighbors;
    });
    // Slow, and no ratio depends on its last digit.
    if (first && cloud != Cloud::WidePlane)
      timed(all_sweep, shapes(sweep));
    first = false;
  }
  state.counters["scales"] = static_cast<double>(scales.radii.size());
  state.counters["neighbors"] = neighbors / static_cast<double>(queries.size());
  state.counters["x_one_pass"] = all / one_pass;
  state.counters["x_one_pass_D_given"] = all_given / one_pass;
  state.counters["x_one_scale"] = all_given / one_scale;
  if (cloud != Cloud::WidePlane)
    state.counters["x_sweep"] = all_sweep / all;
}

} // namespace

void
addMultiScaleBenchmarks()
{
  const std::pair<Cloud, const char*> clouds[] = {
      {Cloud::Line, "line"}, {Cloud::Plane, "plane"}, {Cloud::WidePlane, "wide-plane"}};
  for (const auto& [cloud, cloud_name] : clouds)
    for (const char* kernel : {"const", "fermi-dirac-1", "linear"})
      for (const auto& [centroid, name] : Names<Centroid>::table) {
        const std::string title = std::string("multiscale-cost/") + cloud_name + "/" +
                                  kernel + "/" + std::string(name);
        benchmark::RegisterBenchmark(
            title.c_str(),
            [made_of = cloud, kernel, type = centroid](benchmark::State& state) {
              cost(state, made_of, kernel, type);
            })
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond)
            ->Iterations(3);
      }
}

} // namespace linelet::benchmarking
