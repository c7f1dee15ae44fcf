// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <bench/runs/random_runs.h>

#include <array>

namespace linelet::bench {

namespace {

constexpr std::array<std::size_t, 5> random_counts = {100, 150, 250, 400, 800};
constexpr std::array<double, 3> distributions = {0, 0.5, 1};
constexpr std::array<double, 5> jitters = {0, 0.1, 0.2, 0.4, 0.6};
constexpr int most_outliers = 4; // tenths of N

template <class Values>
auto
oneOf(const Values& values, Random& random)
{
  return values[static_cast<std::size_t>(
      random.integer(0, static_cast<int>(values.size()) - 1))];
}

std::vector<RandomCloudKind>
allKinds()
{
  std::vector<RandomCloudKind> kinds;
  for (const auto& noise : Names<NoiseKind>::table)
    for (const bool flat : {true, false})
      for (const auto& family : Names<ShapeFamily>::table)
        kinds.push_back({family.first, flat, noise.first});
  return kinds;
}

} // namespace

std::vector<BenchmarkRun>
randomRuns(std::size_t count, std::uint32_t seed)
{
  const std::vector<RandomCloudKind> kinds = allKinds();
  Random random(seed);
  std::vector<BenchmarkRun> runs;
  for (std::size_t i = 0; i < count; ++i) {
    BenchmarkRun run;
    run.random = kinds[i % kinds.size()];
    run.sampling.points = oneOf(random_counts, random);
    run.sampling.distribution = oneOf(distributions, random);
    run.sampling.jitter = oneOf(jitters, random);
    run.sampling.outliers = static_cast<std::size_t>(random.integer(0, most_outliers)) *
                            (run.sampling.points / 10);
    run.sampling.seed = (static_cast<std::uint64_t>(seed) << 20) + i + 1;
    runs.push_back(run);
  }
  return runs;
}

} // namespace linelet::bench
