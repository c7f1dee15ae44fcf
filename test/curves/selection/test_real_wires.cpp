// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include <gtest/gtest.h>

#include <bench/measures/segment_tree.h>
#include <linelet/curves/refined_reconstruction.h>
#include <linelet/io/point_file.h>

#include "test_data.h"

using namespace linelet;

namespace {

TEST(RealWires, LieOnCurvesWithTheirPylonAmongThem)
{
  const std::string tile = "lidar/ahn4_12BZ1_21_thin8.las";
  LINELET_NEEDS_DATA(tile);
  const io::Cloud cloud = io::readCloud(test::dataPath(tile).string());
  const io::Column& classes = *cloud.find("classification");
  constexpr double wire = 14, pylon = 15;
  Points points, wires;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const double label = io::valueAt(classes, i);
    if (label == wire)
      wires.push_back(cloud.points[i]);
    if (label == wire || label == pylon)
      points.push_back(cloud.points[i]);
  }
  ASSERT_GT(wires.size(), 10000u);
  const CurveNetwork network = reconstructRefined(points);
  const bench::SegmentTree segments(network);
  std::size_t near = 0;
  for (const Point& point : wires)
    near += segments.nearest(point).squared_distance < 0.25 * 0.25;
  // Whatever is missed is a wire or a part of one.
  EXPECT_GT(static_cast<double>(near) / static_cast<double>(wires.size()), 0.99);
  double total = 0, longest = 0;
  for (const Curve& curve : network.curves) {
    total += length(curve);
    longest = std::max(longest, length(curve));
  }
  // Both spans of a wire are 500 m long, and there are 16 wires.
  EXPECT_GT(longest, 450);
  EXPECT_LT(total, 1.1 * 16 * 510);
}

} // namespace
