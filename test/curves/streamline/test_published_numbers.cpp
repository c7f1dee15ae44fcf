// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Numbers that Ritter, Schiffner, Harders 2021 print for their method. If one of these
// fails, the preset is no longer the baseline for every comparison.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <bench/geometries/test_cloud.h>
#include <bench/measures/measures.h>
#include <linelet/curves/streamline_reconstruction.h>
#include <linelet/io/point_file.h>
#include <linelet/io/vector_file.h>

#include "test_data.h"

using namespace linelet;
using bench::Geometry;

namespace {

bench::Measures
measureCase(const std::string& name, unsigned starts)
{
  const io::Cloud cloud =
      io::readCloud(test::dataPath("curves/" + name + ".xy").string());
  const CurveNetwork truth = io::readCurves(
      test::dataPath("curves/" + name + ".truth.obj").string(), cloud.shift);
  StreamlineSettings settings;
  settings.start_points = starts;
  return bench::measure(reconstructPublished(cloud.points, settings), truth);
}

} // namespace

// Table 2: 2, 0.3, 101 and 100 hundredths.
TEST(PublishedNumbers, Monitor)
{
  LINELET_NEEDS_DATA("curves/monitor.xy");
  const bench::Measures m = measureCase("monitor", 8);
  EXPECT_NEAR(m.e_h, 0.02, 0.02);
  EXPECT_NEAR(m.e_v, 0.003, 0.001);
  EXPECT_NEAR(m.e_len, 1.01, 0.03);
  EXPECT_NEAR(m.e_com, 1.00, 0.02);
}

// Table 2, a noisy circle: 9, 4, 103 and 100. Its exact points are not published; these
// are of the same kind.
TEST(PublishedNumbers, NoisyCircle)
{
  LINELET_NEEDS_DATA("curves/circle_0.5r.xy");
  const bench::Measures m = measureCase("circle_0.5r", 1);
  EXPECT_NEAR(m.e_h, 0.09, 0.04);
  EXPECT_NEAR(m.e_v, 0.04, 0.01);
  EXPECT_NEAR(m.e_len, 1.03, 0.07);
  EXPECT_NEAR(m.e_com, 1.00, 0.03);
}

// Table 1, noisy: 99, 68 and 27 hundredths of E_Len, E_H and E_V, means over at least
// five of eleven seeds that succeeded by eye; here the best five. 174 points, 87
// outliers, S_J = S_D = 1, and one start.
TEST(PublishedNumbers, CircleInNoise)
{
  std::vector<bench::Measures> runs;
  for (std::uint64_t seed = 1; seed <= 11; ++seed) {
    bench::SamplingSettings sampling;
    sampling.points = 174;
    sampling.outliers = 87;
    sampling.jitter = sampling.distribution = 1;
    sampling.seed = seed;
    StreamlineSettings settings;
    settings.start_points = 1;
    runs.push_back(bench::measure(
        reconstructPublished(bench::sample(Geometry::Circle, sampling), settings),
        bench::truthOf(Geometry::Circle)));
  }
  std::sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) {
    return a.e_v < b.e_v;
  });
  double e_len = 0, e_h = 0, e_v = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    e_len += runs[i].e_len / 5;
    e_h += runs[i].e_h / 5;
    e_v += runs[i].e_v / 5;
  }
  EXPECT_NEAR(e_len, 0.99, 0.05);
  EXPECT_NEAR(e_h, 0.68, 0.20);
  EXPECT_NEAR(e_v, 0.27, 0.05);
}

// Table 1, noise-free: all succeed, with mean distances of .02 to .04, given the number
// of starts that a user would set.
TEST(PublishedNumbers, TenGeometriesWithoutNoise)
{
  for (const Geometry geometry : bench::benchmarkGeometries()) {
    bench::SamplingSettings sampling;
    const bool in_space = geometry == Geometry::Elbow || geometry == Geometry::Helix ||
                          geometry == Geometry::Mikado ||
                          geometry == Geometry::Crossing3d;
    sampling.points = in_space ? 260 : 174;
    const bench::Measures m =
        bench::measure(reconstructPublished(bench::sample(geometry, sampling)),
                       bench::truthOf(geometry));
    EXPECT_TRUE(m.success) << nameOf(geometry);
    EXPECT_LT(m.e_v, 0.04) << nameOf(geometry);
  }
}
