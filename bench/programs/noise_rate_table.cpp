// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// benchmark_noise_rate_table [SEEDS] prints, as a Markdown table, the noise rate and
// the noise width of the ten geometries of the benchmark, disturbed in several ways,
// averaged over the sampling seeds 1 to SEEDS (5).

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <bench/geometries/geometries.h>
#include <bench/geometries/test_cloud.h>
#include <linelet/features/multi_scale.h>
#include <linelet/features/noise_rate.h>

using namespace linelet;
using bench::SamplingSettings;

namespace {

struct Column {
  std::string title;
  SamplingSettings sampling;
};

std::vector<Column>
columns()
{
  std::vector<Column> all;
  const auto add = [&](const char* title, double jitter) -> SamplingSettings& {
    all.push_back({title, {}});
    SamplingSettings& sampling = all.back().sampling;
    sampling.points = 512;
    sampling.jitter = jitter;
    return sampling;
  };
  add("J 0", 0);
  add("J .1", 0.1);
  add("J .2", 0.2);
  add("J .4", 0.4);
  add("J .4, S_D 1", 0.4).distribution = 1;
  add("J .4, hole .4-.5", 0.4).hole = {0.4, 0.5};
  add("J .4, N 256", 0.4).points = 256;
  add("J .4, 10 % outliers", 0.4).outliers = 51;
  return all;
}

} // namespace

int
main(int argc, char** argv)
{
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 5;
  if (argc > 2 || seeds < 1) {
    std::fprintf(stderr, "Usage: %s [SEEDS], SEEDS at least 1\n", argv[0]);
    return 2;
  }
  const std::vector<Column> all = columns();
  std::printf("| geometry |");
  for (const Column& column : all)
    std::printf(" %s |", column.title.c_str());
  std::printf("\n|---|");
  for (std::size_t i = 0; i < all.size(); ++i)
    std::printf("---|");
  std::printf("\n");
  constexpr std::size_t geometries = 10; // the others are held out
  for (std::size_t g = 0; g < geometries; ++g) {
    const auto [geometry, name] = Names<bench::Geometry>::table[g];
    std::printf("| %s |", std::string(name).c_str());
    for (const Column& column : all) {
      double rate = 0, width = 0;
      for (int seed = 1; seed <= seeds; ++seed) {
        SamplingSettings sampling = column.sampling;
        sampling.seed = static_cast<std::uint64_t>(seed);
        const Points points = bench::sample(geometry, sampling);
        const auto shapes = multiScaleShapes(points, points).shapes;
        rate += noiseRate(shapes) / seeds;
        width += noiseWidth(shapes) / seeds;
      }
      std::printf(" %.3f / %.3f |", rate, width);
      std::fflush(stdout);
    }
    std::printf("\n");
  }
  return 0;
}
