// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <gtest/gtest.h>

#include <linelet/powerline/power_line_network.h>

#include "powerline/network/fit_catenary.h"
#include "powerline/scene_builder.h"

namespace linelet::powerline {
namespace {

using test::SceneBuilder;

/** A rough model, as it comes from growth. */
SpanModel
roughModel(const Points& points)
{
  SpanModel m;
  Indices all;
  for (std::size_t i = 0; i < points.size(); ++i)
    all.push_back(static_cast<Index>(i));
  const Eigen::Vector2d line = (points.back() - points.front()).head<2>();
  m.origin = points.front().head<2>();
  m.direction = line.normalized();
  m.z[0] = points.front().z();
  m.z[1] = (points.back().z() - points.front().z()) / line.norm();
  m.begin = 0;
  m.end = line.norm();
  EXPECT_TRUE(fit(m, points, all, 50));
  EXPECT_TRUE(fit(m, points, all, 1));
  return m;
}

Indices
everyIndex(const Points& points)
{
  Indices all(points.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = static_cast<Index>(i);
  return all;
}

TEST(Catenary, FollowsTheClosedForm)
{
  Catenary c;
  c.lowest = {10, 20, 5};
  c.a = 400;
  c.azimuth = 90; // toward +x
  c.from = -100;
  c.to = 60;
  EXPECT_NEAR((c.at(0) - c.lowest).norm(), 0, 1e-12);
  const Point p = c.at(50);
  EXPECT_NEAR(p.x(), 60, 1e-9);
  EXPECT_NEAR(p.y(), 20, 1e-9);
  EXPECT_NEAR(p.z(), 5 + 400 * (std::cosh(50.0 / 400) - 1), 1e-9);
  EXPECT_NEAR(c.along(p), 50, 1e-9);
  EXPECT_NEAR(c.distance(p), 0, 1e-9);
  EXPECT_NEAR(c.distance(p + Point(0, 0.3, 0)), 0.3, 1e-9);
}

TEST(Catenary, SwingsToTheRightOfItsAzimuth)
{
  Catenary c;
  c.azimuth = 0; // toward +y, right is +x
  c.a = 300;
  c.swing = 30;
  const double rise = 300 * (std::cosh(80.0 / 300) - 1);
  const Point p = c.at(80);
  EXPECT_NEAR(p.x(), 0.5 * rise, 1e-9);
  EXPECT_NEAR(p.y(), 80, 1e-9);
  EXPECT_NEAR(p.z(), std::sqrt(0.75) * rise, 1e-9);
}

TEST(Catenary, PolylineStaysWithinTheDeviation)
{
  Catenary c;
  c.a = 250;
  c.from = -120;
  c.to = 90;
  for (const double deviation : {0.5, 0.05, 0.005}) {
    const Points vertices = c.polyline(deviation);
    ASSERT_GE(vertices.size(), 2u);
    EXPECT_NEAR((vertices.front() - c.at(c.from)).norm(), 0, 1e-9);
    EXPECT_NEAR((vertices.back() - c.at(c.to)).norm(), 0, 1e-9);
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      const Point middle = (vertices[i - 1] + vertices[i]) / 2;
      // The curve is steepest at its ends: cosh(120 / 250) bounds the slack.
      EXPECT_LE(c.distance(middle), deviation * 1.2);
    }
  }
}

TEST(FitCatenary, ReturnsTheParametersOfExactPoints)
{
  for (const double a : {150.0, 600.0, 1800.0}) {
    const Point from(3, 4, 30), to(203, 104, 36);
    Points points;
    const double length = (to - from).head<2>().norm();
    for (int i = 0; i <= 300; ++i)
      points.push_back(SceneBuilder::onWire(from, to, a, length * i / 300));
    const Catenary c = fitCatenary(roughModel(points), points, everyIndex(points));
    EXPECT_NEAR(c.a, a, 0.01 * a);
    EXPECT_NEAR(c.swing, 0, 0.2);
    EXPECT_NEAR(c.azimuth, 90 - std::atan2(100, 200) * 180 / M_PI, 0.01);
    EXPECT_NEAR((c.at(c.from) - from).norm(), 0, 0.01);
    EXPECT_NEAR((c.at(c.to) - to).norm(), 0, 0.01);
    for (const Point& p : points)
      EXPECT_LT(c.distance(p), 0.005);
  }
}

TEST(FitCatenary, FindsTheSwingOfAWireInTheWind)
{
  Catenary truth;
  truth.lowest = {100, -50, 20};
  truth.a = 900;
  truth.azimuth = 200;
  truth.swing = 12;
  truth.from = -140;
  truth.to = 130;
  SceneBuilder scene(5);
  Points points;
  for (int i = 0; i <= 800; ++i)
    points.push_back(truth.at(truth.from + (truth.to - truth.from) * i / 800) +
                     Point(scene.normal(0.03), scene.normal(0.03), scene.normal(0.03)));
  const Catenary c = fitCatenary(roughModel(points), points, everyIndex(points));
  EXPECT_NEAR(c.swing, 12, 0.5);
  EXPECT_NEAR(c.a, 900, 15);
  EXPECT_NEAR(c.azimuth, 200, 0.05);
  for (double s = truth.from; s < truth.to; s += 10)
    EXPECT_LT(c.distance(truth.at(s)), 0.02);
}

TEST(FitCatenary, IgnoresPointsOffTheWire)
{
  const Point from(0, 0, 15), to(80, 0, 15);
  SceneBuilder scene(7);
  scene.wire(from, to, 500, 4, 0.04);
  const std::size_t of_wire = scene.points.size();
  scene.box({20, -1, 12}, {60, 1, 13.2}, 100); // a tree top, a quarter of all points
  Points sorted = {SceneBuilder::onWire(from, to, 500, 0)};
  sorted.insert(sorted.end(),
                scene.points.begin(),
                scene.points.begin() + static_cast<std::ptrdiff_t>(of_wire));
  sorted.push_back(SceneBuilder::onWire(from, to, 500, 80));
  const SpanModel start = roughModel(sorted);
  const Catenary c = fitCatenary(start, scene.points, everyIndex(scene.points));
  for (double s = 0; s <= 80; s += 5)
    EXPECT_LT(c.distance(SceneBuilder::onWire(from, to, 500, s)), 0.05) << s;
}

TEST(FitCatenary, PassesThroughItsAttachmentPoints)
{
  const Point from(0, 0, 20), to(150, 10, 24);
  SceneBuilder scene(11);
  scene.points = {SceneBuilder::onWire(from, to, 800, 0)};
  scene.wire(from, to, 800, 2, 0.05);
  scene.points.push_back(SceneBuilder::onWire(from, to, 800, 150));
  const SpanModel start = roughModel(scene.points);
  const Catenary c =
      fitCatenary(start, scene.points, everyIndex(scene.points), {from, to});
  EXPECT_LT(c.distance(from), 0.01);
  EXPECT_LT(c.distance(to), 0.01);
}

} // namespace
} // namespace linelet::powerline
