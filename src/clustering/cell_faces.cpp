// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cell_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include <linelet/tensor/eigen_analysis.h>

#include "point_passes.h"

namespace linelet::clustering {

namespace {

/** \brief Corners of a cell: bit a of the number says which end of axis a. */
std::array<Point, 8>
cornersOf(const Cell& cell, const CellFrame& frame)
{
  std::array<Point, 8> corners;
  for (unsigned k = 0; k < corners.size(); ++k) {
    const auto end = [k](unsigned axis) {
      return static_cast<std::int32_t>((k >> axis) & 1U);
    };
    corners[k] = frame.corner({cell[0] + end(0), cell[1] + end(1), cell[2] + end(2)});
  }
  return corners;
}

/** \brief Where the plane through \a center cuts the edges between \a corners, in no
 * order; empty if it does not. */
Points
cut(const std::array<Point, 8>& corners, const Point& center, const Point& normal)
{
  std::array<double, 8> heights{};
  for (std::size_t k = 0; k < corners.size(); ++k)
    heights[k] = normal.dot(corners[k] - center);
  // A plane along a side belongs to the cells on both sides of it.
  const bool above = *std::min_element(heights.begin(), heights.end()) >= 0;
  const auto isUp = [&](double height) { return above ? height > 0 : height >= 0; };
  Points places;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t from = 0; from < corners.size(); ++from) {
      const std::size_t to = from | (std::size_t{1} << axis);
      if (to == from || isUp(heights[from]) == isUp(heights[to]))
        continue;
      const double part = heights[from] / (heights[from] - heights[to]);
      places.push_back(corners[from] + part * (corners[to] - corners[from]));
    }
  return places;
}

/** \brief Puts the corners of a convex face in order around \a normal. */
void
sortAround(const Point& normal, Points& corners)
{
  Point middle = Point::Zero();
  for (const Point& corner : corners)
    middle += corner / static_cast<double>(corners.size());
  const Point right = normal.unitOrthogonal(), up = normal.cross(right);
  const auto angle = [&](const Point& corner) {
    return std::atan2(up.dot(corner - middle), right.dot(corner - middle));
  };
  std::sort(corners.begin(), corners.end(), [&](const Point& a, const Point& b) {
    return angle(a) < angle(b);
  });
}

/** \brief Normal of the members' plane; 0 where they have none. */
Point
planeNormal(const Representative& of)
{
  const EigenSystem system = eigenAnalysis(of.tensor);
  // Below this ratio, rounding alone could turn a row into a plane.
  constexpr double row = 1e-9;
  const bool is_plane = of.count >= 3 && system.values[1] > row * system.values[2];
  return is_plane ? system.normal() : Point::Zero();
}

void
addQuad(Index number,
        const Clusters& clusters,
        const CellFrame& frame,
        std::vector<Face>& faces)
{
  const Representative& of = clusters.representatives[number];
  const Point normal =
      clusters.normals.empty() ? planeNormal(of) : clusters.normals[number];
  if (!(normal.norm() > 0))
    return;
  const std::array<Point, 8> corners = cornersOf(of.cell, frame);
  Points places = cut(corners, of.center, normal);
  // Where most members came from neighboring cells, their plane may miss this cell: it
  // is then cut by a cell around their mean.
  if (places.empty()) {
    std::array<Point, 8> around = corners;
    for (Point& corner : around)
      corner += of.center - frame.middle(of.cell);
    places = cut(around, of.center, normal);
  }
  if (places.size() < 3)
    return;
  sortAround(normal, places);
  faces.push_back({number, std::move(places), normal});
}

void
addBox(Index number,
       const Clusters& clusters,
       const CellDirectory& directory,
       const CellFrame& frame,
       const std::vector<char>& is_filled,
       std::vector<Face>& faces)
{
  const Cell& cell = clusters.representatives[number].cell;
  const std::array<Point, 8> corners = cornersOf(cell, frame);
  Point middle = Point::Zero();
  for (const Point& corner : corners)
    middle += corner / 8;
  for (std::uint32_t face = 0; face < clustering::faces; ++face) {
    const std::size_t axis = face / 2;
    Cell beside = cell;
    beside[axis] += face % 2 == 0 ? -1 : 1;
    const Index slot = directory.find(beside);
    if (slot != CellDirectory::none && is_filled[slot] != 0)
      continue;
    Face side;
    side.part = number;
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (((k >> axis) & 1U) == face % 2)
        side.corners.push_back(corners[k]);
    side.normal = (side.corners[1] - side.corners[0])
                      .cross(side.corners[2] - side.corners[0])
                      .normalized();
    if (side.normal.dot(side.corners[0] - middle) < 0)
      side.normal = -side.normal;
    sortAround(side.normal, side.corners);
    faces.push_back(std::move(side));
  }
}

} // namespace

std::vector<Face>
cellFaces(CellFaces kind,
          const Clusters& clusters,
          const CellDirectory& directory,
          const CellFrame& frame,
          const std::vector<char>& is_filled)
{
  std::vector<Face> faces;
  for (Index k = 0; k < clusters.representatives.size(); ++k)
    if (kind == CellFaces::Quads)
      addQuad(k, clusters, frame, faces);
    else if (kind == CellFaces::Boxes)
      addBox(k, clusters, directory, frame, is_filled, faces);
  return faces;
}

} // namespace linelet::clustering
