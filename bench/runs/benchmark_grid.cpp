// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <bench/runs/benchmark_grid.h>

#include <algorithm>
#include <array>
#include <unordered_set>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

namespace linelet::bench {

namespace {

constexpr std::array<std::size_t, 3> point_counts = {128, 256, 512};
constexpr std::size_t levels = 11;  // of S_D and S_J
constexpr std::size_t outliers = 5; // levels of M
constexpr std::size_t seeds = 7;
// A stratum is a geometry, an N and an S_J; what varies within it comes last in a run's
// number, with the seed fastest.
constexpr std::size_t per_stratum = levels * outliers * seeds;

using Engine = boost::random::mt19937_64;

void
shuffle(std::vector<std::size_t>& values, Engine& random)
{
  for (std::size_t i = values.size(); i > 1; --i)
    std::swap(
        values[i - 1],
        values[boost::random::uniform_int_distribution<std::size_t>(0, i - 1)(random)]);
}

/** \brief \a count numbers below \a range in random order, each equally often. */
std::vector<std::size_t>
balanced(std::size_t count, std::size_t range, Engine& random)
{
  std::vector<std::size_t> order(range), result;
  for (std::size_t i = 0; i < range; ++i)
    order[i] = i;
  while (result.size() < count) {
    shuffle(order, random);
    result.insert(result.end(), order.begin(), order.end());
  }
  result.resize(count);
  shuffle(result, random);
  return result;
}

} // namespace

std::string
shapeName(const BenchmarkRun& run)
{
  return run.random ? kindName(*run.random) : std::string(nameOf(run.geometry));
}

BenchmarkGrid::BenchmarkGrid(const std::vector<Geometry>& geometries)
    : geometries_(geometries)
{
}

std::size_t
BenchmarkGrid::size() const
{
  return geometries_.size() * point_counts.size() * levels * per_stratum;
}

BenchmarkRun
BenchmarkGrid::at(std::size_t index) const
{
  const auto take = [&](std::size_t count) {
    const std::size_t level = index % count;
    index /= count;
    return level;
  };
  const std::size_t seed = take(seeds), m = take(outliers), distribution = take(levels),
                    jitter = take(levels), n = take(point_counts.size());
  BenchmarkRun run;
  run.geometry = geometries_[index];
  run.sampling.points = point_counts[n];
  run.sampling.distribution = static_cast<double>(distribution) / 10;
  run.sampling.jitter = static_cast<double>(jitter) / 10;
  run.sampling.outliers = m * (point_counts[n] / 10);
  run.sampling.seed = seed + 1;
  return run;
}

std::vector<std::size_t>
BenchmarkGrid::stratifiedSample(std::size_t count, std::uint64_t seed) const
{
  std::vector<std::size_t> sample;
  if (count == 0 || count >= size()) {
    for (std::size_t i = 0; i < size(); ++i)
      sample.push_back(i);
    return sample;
  }
  Engine random(seed);
  const auto strata = balanced(count, size() / per_stratum, random);
  const auto distributions = balanced(count, levels, random);
  const auto m = balanced(count, outliers, random);
  const auto run_seeds = balanced(count, seeds, random);
  std::unordered_set<std::size_t> taken;
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t inner = (distributions[i] * outliers + m[i]) * seeds + run_seeds[i];
    // A run that is already taken is replaced by the next free one of its stratum.
    while (!taken.insert(strata[i] * per_stratum + inner).second)
      inner = (inner + 1) % per_stratum;
    sample.push_back(strata[i] * per_stratum + inner);
  }
  std::sort(sample.begin(), sample.end());
  return sample;
}

} // namespace linelet::bench
