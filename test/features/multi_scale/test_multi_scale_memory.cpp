// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <linelet/features/multi_scale.h>

#include "multi_scale_clouds.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANITIZED
#elif defined(__has_feature) // clang
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SANITIZED
#endif
#endif

namespace {

using linelet::MultiScaleSettings;
using linelet::Points;
using linelet::ScaleEngine;
using linelet::ShapeGraph;

constexpr double megabyte = 1 << 20;

/// Peak memory of this process since forgetPeak, in megabytes; 0 if the system does not
/// report it.
double
peak()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmHWM:") {
      double kilobytes = 0;
      status >> kilobytes;
      return kilobytes / 1024;
    }
  return 0;
}

bool
forgetPeak()
{
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;
  return file.good();
}

/// Peaks above the previous level, in megabytes.
struct Peaks {
  double silent, streamed;
};

Peaks
peaksOf(const Points& cloud, const MultiScaleSettings& settings)
{
  Peaks peaks{};
  forgetPeak();
  double before = peak();
  multiScaleShapes(cloud, cloud, settings);
  peaks.silent = peak() - before;

  forgetPeak();
  before = peak();
  std::size_t seen = 0;
  multiScaleShapes(cloud, cloud, settings, [&](std::size_t, const ShapeGraph& graph) {
    seen += graph.size();
  });
  EXPECT_EQ(seen, cloud.size() * settings.radii.size());
  peaks.streamed = peak() - before;
  return peaks;
}

TEST(MultiScaleMemory, GraphsAreNotKept)
{
#ifdef SANITIZED
  GTEST_SKIP() << "a sanitizer's own memory counts in the peak of the process";
#endif
  if (peak() <= 0 || !forgetPeak())
    GTEST_SKIP() << "this system does not report peak memory";
  const Points cloud = linelet_test::randomPoints(24000, 1, {80, 80, 1});
  MultiScaleSettings settings;
  settings.scale_unit = 1;
  settings.threads = 2;
  for (int k = 0; k < 150; ++k)
    settings.radii.push_back(0.5 + 0.01 * k);
  // All graphs would take 96 MB; only some are held at a time.
  settings.engine = ScaleEngine::Grid;
  const Peaks grid = peaksOf(cloud, settings);
  EXPECT_LT(grid.silent, 30); // records, sorted points, buffers
  EXPECT_LT(grid.streamed, 85);

  settings.engine = ScaleEngine::Sweep;
  const Points some(cloud.begin(), cloud.begin() + 8000); // 32 MB
  const Peaks sweep = peaksOf(some, settings);
  EXPECT_LT(sweep.silent, 15);
  EXPECT_LT(sweep.streamed, 26);
}

} // namespace
