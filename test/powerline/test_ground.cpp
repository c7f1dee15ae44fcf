// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "powerline/scene_builder.h"
#include "powerline/terrain/fill_holes.h"
#include "powerline/terrain/find_ground.h"
#include "powerline/terrain/opening.h"

namespace linelet::powerline {
namespace {

using test::SceneBuilder;

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

TEST(OpenRaster, AgreesWithItsDefinition)
{
  SceneBuilder scene(3);
  const int columns = 13, rows = 9;
  std::vector<float> raster;
  for (int i = 0; i < columns * rows; ++i)
    raster.push_back(static_cast<float>(scene.uniform(0, 10)));
  const auto extreme =
      [&](const std::vector<float>& in, int c, int r, int k, bool low) {
        float best = in[static_cast<std::size_t>(r * columns + c)];
        for (int y = std::max(0, r - k); y <= std::min(rows - 1, r + k); ++y)
          for (int x = std::max(0, c - k); x <= std::min(columns - 1, c + k); ++x) {
            const float v = in[static_cast<std::size_t>(y * columns + x)];
            best = low ? std::min(best, v) : std::max(best, v);
          }
        return best;
      };
  for (const int radius : {0, 1, 3, 20}) {
    std::vector<float> eroded(raster.size());
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c)
        eroded[static_cast<std::size_t>(r * columns + c)] =
            extreme(raster, c, r, radius, true);
    const std::vector<float> opened = openRaster(raster, columns, rows, radius);
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c)
        EXPECT_EQ(opened[static_cast<std::size_t>(r * columns + c)],
                  extreme(eroded, c, r, radius, false));
  }
}

TEST(FillHoles, KeepsWhatIsKnownAndStaysBetweenItsNeighbors)
{
  std::vector<float> raster(7 * 5, unknown);
  raster[0] = 2;
  raster[34] = 6;
  std::vector<float> filled = raster;
  fillHoles(filled, 7, 5);
  EXPECT_EQ(filled[0], 2);
  EXPECT_EQ(filled[34], 6);
  for (const float v : filled) {
    EXPECT_GE(v, 2);
    EXPECT_LE(v, 6);
  }
  std::vector<float> nothing(4, unknown);
  fillHoles(nothing, 2, 2);
  for (const float v : nothing)
    EXPECT_TRUE(std::isnan(v));
}

/** Rolling terrain: slopes up to 0.35. */
double
hills(double x, double y)
{
  return 8 * std::sin(x / 30) + 5 * std::cos(y / 25);
}

TEST(FindGround, SeesThroughHousesTreesAndPits)
{
  SceneBuilder scene(17);
  Points points;
  for (int i = 0; i < 60000; ++i) {
    const double x = scene.uniform(0, 150), y = scene.uniform(0, 150);
    double z = hills(x, y) + scene.normal(0.03);
    if (x > 40 && x < 60 && y > 40 && y < 55)
      z = hills(50, 47) + 9; // a house: no ground below it
    else if (std::hypot(x - 100, y - 100) < 25 && scene.uniform(0, 1) < 0.9)
      z += scene.uniform(4, 15); // a wood: one pulse in ten reaches the ground
    points.emplace_back(x, y, z);
  }
  points.emplace_back(20, 20, hills(20, 20) - 12); // multipath
  const Ground ground = findGround(points, {}, false);
  double squares = 0, count = 0, worst = 0;
  for (double x = 4; x < 146; x += 3)
    for (double y = 4; y < 146; y += 3) {
      const double off = std::abs(ground.heightAt(x, y) - hills(x, y));
      const bool below_house = x > 38 && x < 62 && y > 38 && y < 57;
      worst = std::max(worst, below_house ? off / 2 : off);
      if (below_house)
        continue;
      squares += off * off;
      ++count;
    }
  EXPECT_LT(worst, 1.2);
  EXPECT_LT(std::sqrt(squares / count), 0.15);
}

TEST(FindGround, WiresOverWaterAreNotTerrain)
{
  // Banks at height 0, water without a return from 100 to 400, six wires 25 m above.
  SceneBuilder scene(29);
  scene.ground(0, 0, 100, 100, 3);
  scene.ground(400, 0, 500, 100, 3);
  for (int wire = 0; wire < 6; ++wire)
    for (double x = 0; x < 500; x += 0.25)
      scene.points.emplace_back(x, 30 + 8 * wire, 25 + scene.normal(0.03));
  const Ground ground = findGround(scene.points, {}, false);
  for (double x = 10; x < 490; x += 10)
    for (double y = 10; y < 95; y += 5)
      EXPECT_NEAR(ground.heightAt(x, y), 0, 1) << x << ' ' << y;
}

TEST(FindGround, KeepsRidgesOfMountains)
{
  // A roof-shaped ridge of 40 degrees, 60 m high.
  SceneBuilder scene(31);
  Points points;
  const auto height = [](double x) { return 60 - std::tan(0.7) * std::abs(x - 75); };
  for (int i = 0; i < 60000; ++i) {
    const double x = scene.uniform(0, 150), y = scene.uniform(0, 150);
    points.emplace_back(x, y, height(x) + scene.normal(0.03));
  }
  const Ground ground = findGround(points, {}, false);
  for (double x = 5; x < 145; x += 5)
    EXPECT_NEAR(ground.heightAt(x, 75), height(x), 2) << x;
}

TEST(FindGround, KeepsTheUpperEndOfASteepStrip)
{
  // Nothing is scanned on either side of a strip that climbs along its length: to the
  // rasters, its upper end looks like a summit.
  for (const double heading : {0.0, 0.6, 1.0, 2.5}) {
    SCOPED_TRACE(heading);
    SceneBuilder scene(9);
    Points points;
    const auto height = [](double along) { return 300 + 0.95 * along; };
    for (int i = 0; i < 20000; ++i) {
      const double along = scene.uniform(-100, 0), across = scene.uniform(-16, 16);
      points.emplace_back(along * std::cos(heading) - across * std::sin(heading),
                          along * std::sin(heading) + across * std::cos(heading),
                          height(along) + scene.uniform(-0.1, 0.1));
    }
    const Ground g = findGround(points, {}, false);
    int far = 0;
    for (const Point& p : points)
      far += std::abs(p.z() - g.heightAt(p.x(), p.y())) > 1.5;
    EXPECT_LE(far, 100);
  }
}

TEST(FindGround, TakesClassTwoWhenAsked)
{
  SceneBuilder scene(19);
  scene.ground(0, 0, 30, 30, 5);
  std::vector<std::uint8_t> classes(scene.points.size(), 2);
  scene.box({0, 0, 6}, {30, 30, 6.1}, 4000); // a roof over everything
  classes.resize(scene.points.size(), 6);
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    if (classes[i] == 6)
      scene.points[i].z() -= 20; // even below the ground
  EXPECT_NEAR(findGround(scene.points, classes, true).heightAt(15, 15), 0, 0.05);
  EXPECT_LT(findGround(scene.points, classes, false).heightAt(15, 15), -13);
}

TEST(FindGround, CopesWithNothingAndWithStrayPoints)
{
  EXPECT_TRUE(findGround({}, {}, false).heights.empty());
  EXPECT_TRUE(std::isnan(findGround({}, {}, false).heightAt(1, 2)));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(findGround({{nan, 0, 0}}, {}, false).heights.empty());
  const Ground one = findGround({{5, 5, 7}}, {}, false);
  EXPECT_NEAR(one.heightAt(5, 5), 7, 1e-6);
  EXPECT_NEAR(one.heightAt(-100, 900), 7, 1e-6);
  // One point a thousand kilometers away must not exhaust memory.
  SceneBuilder scene(23);
  scene.ground(0, 0, 20, 20, 5);
  scene.points.emplace_back(1e6, 1e6, 3);
  EXPECT_LT(findGround(scene.points, {}, false).heights.size(), 2000000u);
}

} // namespace
} // namespace linelet::powerline
