// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/point_file.h>

#include "features/simd_grid/test_grid_engine.h"
#include "test_data.h"

using namespace linelet;
using namespace linelet::test;

namespace {

/** \brief Real scans: coordinates on a lattice of millimeters or centimeters, so that
 * distances equal to the radius are common; 1 to 1000 points per square meter. */
void
compareOn(const std::string& file)
{
  const io::Cloud cloud = io::readCloud(dataPath(file).string());
  ASSERT_GT(cloud.points.size(), 1000u);
  for (const char* weight : {"const", "fermi-dirac-1", "quadratic-inverse"})
    for (const Centroid centroid :
         {Centroid::QueryPoint, Centroid::Mean, Centroid::WeightedMean})
      for (const double radius : {0.3, 1.0, 4.0}) {
        SCOPED_TRACE(file + ", " + weight + ", " + std::string(nameOf(centroid)) +
                     ", radius " + std::to_string(radius));
        TensorSettings settings;
        settings.radius = radius;
        settings.weighting = Weighting(weight);
        settings.centroid = centroid;
        EXPECT_TRUE(gridAgrees(cloud.points, settings, {}, 500));
      }
}

} // namespace

TEST(GridEngineTiles, AgreesOnAirborneLidar)
{
  LINELET_NEEDS_DATA("lidar/williams_east.las");
  compareOn("lidar/williams_east.las");
}

TEST(GridEngineTiles, AgreesOnAHighVoltageLine)
{
  LINELET_NEEDS_DATA("lidar/ahn4_12BZ1_21_thin8.las");
  compareOn("lidar/ahn4_12BZ1_21_thin8.las");
}
