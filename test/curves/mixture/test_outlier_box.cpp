// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Curves among uniform outliers: the box that the outliers are assumed to fill.

#include <cmath>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <bench/geometries/test_cloud.h>
#include <bench/measures/measures.h>
#include <linelet/curves/refined_reconstruction.h>
#include <linelet/search/scale_unit.h>

#include "curves/mixture/em_fit.h"

using namespace linelet;

namespace {

// For points spread equally in all directions the principal directions are arbitrary; a
// box along them would be up to twice as large as the one that the points fill.
TEST(OutlierBox, IsThatOfPointsUniformInOne)
{
  boost::random::mt19937 random(5);
  boost::random::uniform_real_distribution<double> side(-5, 5);
  for (const bool flat : {false, true})
    for (int run = 0; run < 20; ++run) {
      SCOPED_TRACE(run);
      Points points;
      for (int i = 0; i < 500; ++i) {
        const double x = side(random), y = side(random);
        points.emplace_back(x, y, flat ? 2 : side(random));
      }
      const CloudFrame frame = frameOf(points, scaleUnit(points, 1024, 1, 1));
      ASSERT_EQ(frame.dimensions, flat ? 2 : 3);
      const double volume = flat ? 100 : 1000;
      EXPECT_GT(frame.volume, 0.9 * volume);
      EXPECT_LE(frame.volume, volume);
    }
}

// A flat cloud that is aligned with no axis keeps the area of its plane.
TEST(OutlierBox, OfATiltedPlaneIsAnArea)
{
  boost::random::mt19937 random(5);
  boost::random::uniform_real_distribution<double> side(-5, 5);
  Points points;
  for (int i = 0; i < 500; ++i) {
    const double x = 2 * side(random), y = side(random);
    points.emplace_back(x, y * std::sqrt(0.5), y * std::sqrt(0.5));
  }
  const CloudFrame frame = frameOf(points, scaleUnit(points, 1024, 1, 1));
  ASSERT_EQ(frame.dimensions, 2);
  EXPECT_NEAR(frame.volume, 200, 30);
}

// Too large a box makes outliers so improbable that curves through them pay for their
// parameters: then one in ten of these circles is found.
TEST(OutlierBox, ThickCirclesAmongMoreOutliersThanPointsAreFound)
{
  using namespace bench;
  const CurveNetwork truth = truthOf(Geometry::Circle);
  int found = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SamplingSettings sampling;
    sampling.points = 174;
    sampling.jitter = 1;
    sampling.outliers = 261;
    sampling.seed = seed;
    const CurveNetwork network =
        reconstructRefined(sample(Geometry::Circle, sampling), {});
    found += measure(network, truth).success;
  }
  EXPECT_GE(found, 30);
}

} // namespace
