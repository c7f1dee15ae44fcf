// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Scaled-down versions of clouds larger than a test shape.
#include <atomic>
#include <cmath>

#include <sys/resource.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <bench/geometries/geometries.h>
#include <bench/geometries/test_cloud.h>
#include <bench/measures/measures.h>
#include <linelet/curves/refined_reconstruction.h>

using namespace linelet;
using namespace linelet::bench;

namespace {

/** \brief Shapes side by side, \a distance apart. */
Points
shapes(std::size_t count, std::size_t points, double distance, CurveNetwork& truth)
{
  const Geometry kinds[] = {
      Geometry::Line, Geometry::Helix, Geometry::Wave, Geometry::Circle};
  Points cloud;
  for (std::size_t c = 0; c < count; ++c) {
    SamplingSettings settings;
    settings.points = points;
    settings.jitter = 0.1;
    settings.distribution = 1;
    settings.outliers = points / 50;
    settings.seed = c + 1;
    const Point place(distance * static_cast<double>(c), 0, 0);
    for (const Point& p : sample(kinds[c % 4], settings))
      cloud.push_back(p + place);
    for (Curve curve : truthOf(kinds[c % 4]).curves) {
      for (Point& p : curve.points)
        p += place;
      truth.curves.push_back(std::move(curve));
    }
  }
  return cloud;
}

struct Counting : ProgressMonitor {
  void
  begin(std::string_view, std::size_t total) override
  {
    total_ = total;
    done_ = 0;
  }
  void
  advance(std::size_t steps) override
  {
    done_ += steps;
    ++advances_;
  }
  bool
  canceled() const override
  {
    if (done_ >= cancel_at_)
      ++asked_after_;
    return done_ >= cancel_at_;
  }

  std::atomic<std::size_t> total_{0}, done_{0}, advances_{0};
  std::size_t cancel_at_ = static_cast<std::size_t>(-1);
  mutable std::atomic<std::size_t> asked_after_{0};
};

TEST(LargeReconstruction, ManyCurvesAreFoundOneByOne)
{
  CurveNetwork truth;
  const Points cloud = shapes(20, 2000, 20, truth);
  Counting monitor;
  const CurveNetwork found = reconstructRefined(cloud, {}, &monitor);
  EXPECT_EQ(found.curves.size(), 20u);
  const Measures m = measure(found, truth);
  EXPECT_TRUE(m.success);
  EXPECT_LT(m.e_v, 0.03);
  EXPECT_LE(monitor.done_, monitor.total_);
  EXPECT_GE(monitor.advances_, 20u);
}

TEST(LargeReconstruction, CurvesThickerThanTheSpacingAreNotVolumes)
{
  // A tube of noise around every curve is so dense that few neighborhoods at the scale
  // of the spacing are linear.
  CurveNetwork truth;
  const Points cloud = shapes(2, 20000, 20, truth);
  const Measures m = measure(reconstructRefined(cloud), truth);
  EXPECT_TRUE(m.success);
  EXPECT_LT(m.e_v, 0.05);
}

TEST(LargeReconstruction, OnePartOfManyPointsIsFitted)
{
  // Too many points in one component to try all bandwidths.
  SamplingSettings settings;
  settings.points = 70000;
  settings.jitter = 0.002;
  Counting monitor;
  const CurveNetwork found =
      reconstructRefined(sample(Geometry::Helix, settings), {}, &monitor);
  const Measures m = measure(found, truthOf(Geometry::Helix));
  EXPECT_TRUE(m.success);
  EXPECT_LT(m.e_v, 0.005);
  EXPECT_GT(monitor.advances_, 1u);
}

TEST(LargeReconstruction, CanceledWithinAPart)
{
  CurveNetwork truth;
  const Points cloud = shapes(1, 20000, 20, truth);
  Counting monitor;
  monitor.cancel_at_ = 1; // the first report of progress
  RefinedSettings settings;
  settings.threads = 1;
  EXPECT_THROW(reconstructRefined(cloud, settings, &monitor), Canceled);
  // Nothing starts after the first "true".
  EXPECT_LE(monitor.asked_after_, 2u);
}

TEST(LargeReconstruction, CrowdsDoNotMultiplyTheWork)
{
  // Half of the points crowd into the space of a handful: without bounds, all would be
  // neighbors, 10^10 pairs.
  boost::random::mt19937 random(11);
  boost::random::uniform_real_distribution<double> uniform(-1, 1);
  Points cloud;
  for (int i = 0; i < 120000; ++i)
    cloud.emplace_back(100 * uniform(random), 0, 0);
  for (int i = 0; i < 100000; ++i)
    cloud.emplace_back(
        1e-4 * uniform(random), 1 + 1e-4 * uniform(random), 1e-4 * uniform(random));
  const CurveNetwork found = reconstructRefined(cloud);
  EXPECT_NEAR(length(found), 200, 2);
}

/** \brief The peak memory of this program so far, in megabytes. */
long
peakMemory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

TEST(LargeReconstruction, FewPointsFarOutDoNotMultiplyTheWork)
{
  // A mesh of noisy wires as one component. Its farthest points, a hundred times as
  // sparse as the others, stay unexplained; a fit that starts with noise as wide as
  // their spacing pairs each point with hundreds of places.
  boost::random::mt19937 random(5);
  boost::random::uniform_real_distribution<double> uniform(-50, 50);
  boost::random::normal_distribution<double> noise(0, 0.03);
  Points cloud;
  for (int i = 0; i < 200000; ++i) {
    const double along = uniform(random), wire = 2.0 * (i % 51) - 50;
    const Point p = i % 2 == 0 ? Point(along, wire, 0) : Point(wire, along, 0);
    cloud.push_back(p + Point(noise(random), noise(random), noise(random)));
  }
  const long before = peakMemory();
  const CurveNetwork found = reconstructRefined(cloud);
  EXPECT_LT(peakMemory() - before, 600);
  EXPECT_NEAR(length(found), 102 * 100, 102);
}

TEST(LargeReconstruction, TouchingWiresAreSeparatedInALargeMesh)
{
  // Wires that sway and cross, about 65,000 points in one component: at each crossing
  // they may be joined wrongly, or end.
  boost::random::mt19937 random(21);
  boost::random::uniform_real_distribution<double> uniform(0, 1);
  boost::random::normal_distribution<double> noise(0, 0.03);
  constexpr std::size_t wires = 34, points = 1900;
  constexpr double side = 60;
  Points cloud;
  for (std::size_t w = 0; w < wires; ++w) {
    const double from = side * uniform(random), to = side * uniform(random);
    for (std::size_t i = 0; i < points; ++i) {
      const double t = uniform(random), along = side * t;
      const double across =
          from + (to - from) * t + 1.5 * std::sin(6 * t + static_cast<double>(w));
      const Point p = w % 2 == 0 ? Point(along, across, 0) : Point(across, along, 0);
      cloud.push_back(p + Point(noise(random), noise(random), noise(random)));
    }
  }
  EXPECT_LE(reconstructRefined(cloud).curves.size(), 2 * wires);
}

TEST(LargeReconstruction, PointsOnOthersCountAsOneForTheScale)
{
  SamplingSettings settings;
  settings.jitter = 0.1;
  const Points once = sample(Geometry::Helix, settings);
  Points cloud = once;
  for (int copy = 0; copy < 7; ++copy)
    cloud.insert(cloud.end(), once.begin(), once.end());
  EXPECT_TRUE(measure(reconstructRefined(cloud), truthOf(Geometry::Helix)).success);
}

} // namespace
