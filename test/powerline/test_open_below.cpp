// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "powerline/pieces/open_below.h"

namespace linelet::powerline {
namespace {

/** A wire along x at a height of 10 m, 20 m long, 4 points per meter. */
class OpenBelow : public ::testing::Test {
protected:
  OpenBelow()
  {
    wire_.z[0] = 10;
    wire_.end = 20;
    row(0, 10);
  }

  // Points beside the wire, as in a scan line.
  void
  row(double y, double z)
  {
    for (double x = 0; x <= 20; x += 0.25)
      points_.emplace_back(x, y, z);
  }

  double
  open() const
  {
    return openBelow(wire_, Underside(points_));
  }

  bool
  isOpen() const
  {
    return isOpenBelow(wire_, Underside(points_));
  }

  SpanModel wire_;
  Points points_;
};

TEST_F(OpenBelow, OverTheGround)
{
  for (double y = -5; y <= 5; y += 0.5)
    row(y, 0);
  EXPECT_EQ(open(), 1);
}

TEST_F(OpenBelow, OverWaterWhereNothingReturns)
{
  EXPECT_EQ(open(), 1);
  EXPECT_TRUE(isOpen());
}

TEST_F(OpenBelow, BelowTheNextArm)
{
  row(1.25, 14);
  EXPECT_EQ(open(), 1);
}

TEST_F(OpenBelow, RowsOfARoofAreClosedHoweverFarApart)
{
  for (const double spacing : {0.5, 1.2, 2.3}) {
    points_.clear();
    for (int k = -3; k <= 3; ++k)
      row(k * spacing, 10 + 0.4 * k * spacing);
    EXPECT_FALSE(isOpen()) << "rows " << spacing << " m apart";
  }
}

TEST_F(OpenBelow, CrownsUnderALittleOfItDoNotCloseIt)
{
  for (double y = -5; y <= 5; y += 0.5)
    row(y, 0);
  for (Point& p : points_)
    if (p.z() == 0 && p.x() < 6)
      p.z() = 9;
  EXPECT_LT(open(), 1);
  EXPECT_TRUE(isOpen());
}

} // namespace
} // namespace linelet::powerline
