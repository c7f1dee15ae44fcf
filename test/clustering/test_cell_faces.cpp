// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "clustering/cluster_fixture.h"

using namespace linelet;
using namespace linelet::test;

namespace {

Point
areaVector(const Face& face)
{
  Point sum = Point::Zero();
  for (std::size_t k = 1; k + 1 < face.corners.size(); ++k)
    sum += (face.corners[k] - face.corners[0])
               .cross(face.corners[k + 1] - face.corners[0]) /
           2;
  return sum;
}

/** \brief Points of the plane with that normal through the middle of a cube of edge
 * \a n, dense enough to be in every cell that it cuts by more than a corner. */
Points
planeInCube(double n, const Point& normal)
{
  const Point right = normal.unitOrthogonal(), up = normal.cross(right);
  const Point middle = Point::Constant(n / 2);
  // The corners fix the grid.
  Points points = {Point::Zero(), Point::Constant(n)};
  for (double a = -2 * n; a <= 2 * n; a += 0.05)
    for (double b = -2 * n; b <= 2 * n; b += 0.05) {
      const Point at = middle + a * right + b * up;
      if (at.minCoeff() > 0 && at.maxCoeff() < n)
        points.push_back(at);
    }
  return points;
}

ClusterSettings
cube(double n, CellFaces faces)
{
  ClusterSettings settings;
  settings.cells = {n, n, n};
  settings.moves = 0;
  settings.faces = faces;
  return settings;
}

TEST(CellFaces, AreMadeOnRequestOnly)
{
  EXPECT_TRUE(clusterPoints(house(1000, 1), settingsOf(1, 1)).faces.empty());
  EXPECT_TRUE(clusterPoints({}, cube(3, CellFaces::Quads)).faces.empty());
  EXPECT_TRUE(clusterPoints({}, cube(3, CellFaces::Boxes)).faces.empty());
}

TEST(CellFaces, QuadsCoverAPlaneOnceWhateverItsDirection)
{
  // The cuts of all cells together are the cut of the cube, whose area is known.
  constexpr double n = 4, pi = M_PI;
  const std::pair<Point, double> planes[] = {
      {Point(0.3, 0, 1).normalized(), n * n * std::hypot(1, 0.3)},
      {Point(0, -0.5, 0.2).normalized(), n * n * std::hypot(1, 0.4)},
      // The regular hexagon between the corners of the cube.
      {Point(1, 1, 1).normalized(), n * n * std::sqrt(27. / 16)}};
  for (const auto& [normal, area] : planes) {
    const Clusters clusters =
        clusterPoints(planeInCube(n, normal), cube(n, CellFaces::Quads));
    double sum = 0;
    for (const Face& face : clusters.faces) {
      EXPECT_GT(std::abs(face.normal.dot(normal)), std::cos(0.01 * pi / 180));
      // Counterclockwise around its normal.
      EXPECT_GT(areaVector(face).dot(face.normal), 0);
      EXPECT_GE(face.corners.size(), 3u);
      EXPECT_LE(face.corners.size(), 6u);
      sum += areaVector(face).norm();
    }
    // Slivers at corners of cells hold no or too few points.
    EXPECT_NEAR(sum / area, 1, 0.01) << normal.transpose();
    EXPECT_LT(sum / area, 1 + 1e-6) << normal.transpose();
  }
}

TEST(CellFaces, CornersOfQuadsLieOnThePlaneAndOnEdgesOfTheCell)
{
  const Points points = house(20000, 4);
  ClusterSettings settings = settingsOf(1, 0);
  settings.faces = CellFaces::Quads;
  const Clusters clusters = clusterPoints(points, settings);
  ASSERT_GT(clusters.faces.size(), 200u);
  const Point low = lowest(points);
  for (const Face& face : clusters.faces) {
    const Representative& of = clusters.representatives[face.part];
    for (const Point& corner : face.corners) {
      EXPECT_NEAR(face.normal.dot(corner - of.center), 0, 1e-9);
      int on_sides = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        const auto axis = static_cast<Eigen::Index>(a);
        const double at = corner[axis] - low[axis] - of.cell[a];
        EXPECT_GT(at, -1e-9);
        EXPECT_LT(at, 1 + 1e-9);
        on_sides += std::abs(at - std::round(at)) < 1e-9 ? 1 : 0;
      }
      EXPECT_GE(on_sides, 2);
    }
  }
}

TEST(CellFaces, MovedCellsHaveQuadsThroughTheirMeanToo)
{
  ClusterSettings settings = settingsOf(1, 4);
  settings.faces = CellFaces::Quads;
  const Clusters clusters = clusterPoints(house(20000, 5, 0.2), settings);
  std::size_t planes = 0;
  for (const Representative& one : clusters.representatives)
    planes += one.count > 3 ? 1 : 0;
  EXPECT_GE(clusters.faces.size(), planes);
  for (const Face& face : clusters.faces)
    for (const Point& corner : face.corners)
      EXPECT_NEAR(face.normal.dot(corner - clusters.representatives[face.part].center),
                  0,
                  1e-9);
}

TEST(CellFaces, WithoutAPlaneThereIsNoQuad)
{
  Points row;
  for (int i = 0; i < 300; ++i)
    row.emplace_back(0.01 * i, 0.02 * i, 0.005 * i);
  for (const Points& points : {Points{Point(1, 2, 3)}, Points(7, Point(1, 2, 3)), row})
    for (const double n : {1., 5.}) {
      EXPECT_TRUE(clusterPoints(points, cube(n, CellFaces::Quads)).faces.empty());
      // But it has boxes, and normals toward empty cells give it quads.
      EXPECT_FALSE(clusterPoints(points, cube(n, CellFaces::Boxes)).faces.empty());
    }
  ClusterSettings settings = cube(5, CellFaces::Quads);
  settings.normals = NormalRule::EmptyCells;
  const Clusters clusters = clusterPoints(row, settings);
  EXPECT_EQ(clusters.faces.size(), clusters.representatives.size());
}

TEST(CellFaces, FlatCloudsHaveOneLayerOfQuads)
{
  Points points;
  for (double x = 0; x <= 6; x += 0.1)
    for (double y = 0; y <= 6; y += 0.1)
      points.emplace_back(x, y, 7);
  const Clusters clusters = clusterPoints(points, cube(6, CellFaces::Quads));
  double sum = 0;
  for (const Face& face : clusters.faces)
    sum += areaVector(face).norm();
  EXPECT_EQ(clusters.faces.size(), 36u);
  EXPECT_NEAR(sum, points.back().x() * points.back().y(), 1e-9);
}

/** \brief Boxes are closed: every edge between two corners has as many sides in one
 * direction as in the other, and the volume inside is that of the cells. */
void
expectClosed(const Clusters& clusters, double volume)
{
  const auto key = [](const Point& p) {
    return std::array<long long, 3>{std::llround(p.x() * 1e6),
                                    std::llround(p.y() * 1e6),
                                    std::llround(p.z() * 1e6)};
  };
  std::map<std::pair<std::array<long long, 3>, std::array<long long, 3>>, int> edges;
  double within = 0;
  for (const Face& face : clusters.faces) {
    ASSERT_EQ(face.corners.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto from = key(face.corners[k]), to = key(face.corners[(k + 1) % 4]);
      ++edges[{from, to}];
      --edges[{to, from}];
    }
    within += face.corners[0].dot(areaVector(face)) / 3;
    EXPECT_GT(areaVector(face).dot(face.normal), 0);
  }
  for (const auto& [edge, sum] : edges)
    ASSERT_EQ(sum, 0);
  EXPECT_NEAR(within / volume, 1, 1e-9);
}

TEST(CellFaces, BoxesAreAClosedSurfaceAroundTheCells)
{
  ClusterSettings settings = settingsOf(0.8, 0);
  settings.faces = CellFaces::Boxes;
  const Clusters clusters = clusterPoints(house(5000, 6), settings);
  expectClosed(clusters,
               static_cast<double>(clusters.representatives.size()) * std::pow(0.8, 3));
  // A lone cell has six sides.
  EXPECT_EQ(clusterPoints({Point(1, 1, 1)}, settings).faces.size(), 6u);
  // A row of three has fourteen.
  EXPECT_EQ(clusterPoints({Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0)}, settings)
                .faces.size(),
            14u);
}

TEST(CellFaces, InTheViewOfACameraBoxesArePiecesOfIt)
{
  ClusterSettings settings = cube(12, CellFaces::Boxes);
  Camera camera;
  camera.lookAt(Point(9, -20, 8), Point(9, 6, 2));
  camera.near = 10;
  camera.far = 40;
  settings.camera = camera;
  const Clusters clusters = clusterPoints(house(20000, 7), settings);
  ASSERT_GT(clusters.representatives.size(), 20u);
  // A frustum between depths a and b, whose sides grow with depth.
  const double tangent = std::tan(30 * M_PI / 180);
  double volume = 0;
  for (const Representative& one : clusters.representatives) {
    const double a = 10 * std::pow(4, one.cell[2] / 12.);
    const double b = 10 * std::pow(4, (one.cell[2] + 1) / 12.);
    const double base = 4 * tangent * tangent * camera.width / camera.height / 144;
    volume += base * (b * b * b - a * a * a) / 3;
  }
  expectClosed(clusters, volume);
  settings.faces = CellFaces::Quads;
  EXPECT_GT(clusterPoints(house(20000, 7), settings).faces.size(), 20u);
}

} // namespace
