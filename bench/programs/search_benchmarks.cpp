// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchmarks.h"

#include <algorithm>
#include <string>

#include <benchmark/benchmark.h>

#include <linelet/search/uniform_grid.h>

#include "rivals.h"
#include "scenes.h"

namespace linelet::benchmarking {

namespace {

constexpr std::size_t sample = 10000;

void
build(benchmark::State& state, Scene which, std::size_t count)
{
  const Points& points = scene(which, count, Order::Shuffled);
  const double radius = radiusFor(which, 20);
  const double flann = flannSearch(points, radius, 1).build;
  const double nanoflann = nanoflannSearch(points, radius, 1).build;
  double best = 1e9;
  for (auto _ : state) {
    const double start = cpuSeconds();
    const UniformGrid grid(points, radius);
    benchmark::DoNotOptimize(grid.size());
    const double seconds = cpuSeconds() - start;
    state.SetIterationTime(seconds);
    best = std::min(best, seconds);
  }
  state.counters["us_per_point"] = best / static_cast<double>(count) * 1e6;
  state.counters["x_flann"] = flann / best;
  state.counters["x_nanoflann"] = nanoflann / best;
}

template <class Query>
double
timeOfQueries(const Points& points, const Query& query)
{
  const std::size_t step = points.size() / sample;
  const double start = cpuSeconds();
  for (std::size_t i = 0; i < sample; ++i)
    query(points[i * step]);
  return (cpuSeconds() - start) / static_cast<double>(sample);
}

void
radiusSearch(benchmark::State& state, Scene which, double neighbors)
{
  const Points& points = scene(which, 200000, Order::Shuffled);
  const double radius = radiusFor(which, neighbors);
  const UniformGrid grid(points, radius);
  const double flann = flannSearch(points, radius, sample).query;
  const double nanoflann = nanoflannSearch(points, radius, sample).query;
  double best = 1e9;
  Indices found;
  for (auto _ : state) {
    const double seconds = timeOfQueries(points, [&](const Point& query) {
      found.clear();
      grid.forEachWithin(query, radius, [&](Index i, double) { found.push_back(i); });
    });
    state.SetIterationTime(seconds);
    best = std::min(best, seconds);
  }
  state.counters["us_per_query"] = best * 1e6;
  state.counters["x_flann"] = flann / best;
  state.counters["x_nanoflann"] = nanoflann / best;
}

void
nearest(benchmark::State& state, Scene which, std::size_t count)
{
  const Points& points = scene(which, 200000, Order::Shuffled);
  const UniformGrid grid(points, radiusFor(which, 6));
  const double nanoflann = nanoflannNearest(points, count, sample).query;
  double best = 1e9;
  for (auto _ : state) {
    const double seconds = timeOfQueries(points, [&](const Point& query) {
      benchmark::DoNotOptimize(grid.nearestK(query, count));
    });
    state.SetIterationTime(seconds);
    best = std::min(best, seconds);
  }
  state.counters["us_per_query"] = best * 1e6;
  state.counters["x_nanoflann"] = nanoflann / best;
}

template <class Run>
void
add(const std::string& name, Run run)
{
  benchmark::RegisterBenchmark(name.c_str(), run)
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond)
      ->Iterations(3);
}

} // namespace

void
addSearchBenchmarks()
{
  for (const Scene which : {Scene::Volume, Scene::Surface}) {
    const std::string where = which == Scene::Volume ? "/volume" : "/surface";
    for (const std::size_t count : {200000U, 2000000U})
      add("build" + where + "/points:" + std::to_string(count),
          [=](benchmark::State& state) { build(state, which, count); });
    for (const double neighbors : {10.0, 100.0, 500.0, 5000.0})
      add("search" + where +
              "/neighbors:" + std::to_string(static_cast<int>(neighbors)),
          [=](benchmark::State& state) { radiusSearch(state, which, neighbors); });
    for (const std::size_t count : {1U, 6U, 20U})
      add("nearest" + where + "/k:" + std::to_string(count),
          [=](benchmark::State& state) { nearest(state, which, count); });
  }
}

} // namespace linelet::benchmarking
