// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/features/multi_scale_settings.h>
#include <linelet/io/cloud.h>
#include <linelet/screen/screen_normals.h>
#include <linelet/support/names.h>

#include "canvas.h"
#include "frame.h"

namespace linelet::apps {

/** \brief What a picture shows. */
enum class PictureKind {
  Cloud,      ///< the points, colored
  Profile,    ///< the multi-scale feature image along a line
  Graphs,     ///< the graphs of one point
  Splats,     ///< the tensors of the points, as striped discs
  Ellipsoids, ///< the same as ellipsoids
  CellSplats, ///< the cells of a grid by the tensors of their members, as discs
  CellQuads,  ///< as the planes of their members
  CellBoxes   ///< as boxes
};

/** \brief What is drawn, and how. */
struct PictureSettings {
  PictureKind kind = PictureKind::Cloud;
  ShapeColors colors = ShapeColors::Classic;
  unsigned width = 1200, height = 760;
  // Cloud
  std::string color = "shape";
  std::string curves;
  double azimuth = 210, elevation = 35;
  double point_size = 0;
  double curve_width = 3;
  bool fourth_order = false;
  /// Points are larger than their spacing, so their edges need averaging.
  ScreenNormalSettings normals = {ScreenNormalMethod::Tensor, 25, 0, 4, 0};
  // Splats and ellipsoids
  double radius = 0, size = 0;
  bool tensors = false;
  SplatColors splat_colors = SplatColors::Safe;
  double cell_size = 0;
  // Profile and graphs
  std::string along;
  bool by_index = false;
  std::vector<double> probe;
  std::vector<double> point;
  double length = 0;
  unsigned columns = 400, rows = 64;
  std::string title;
};

template <class Visit>
void
describe(PictureSettings& s, Visit&& visit)
{
  visit("kind",
        s.kind,
        "what to draw; --along and --probe make it a profile, --point graphs");
  visit("colors", s.colors, "colors of linearity, planarity and sphericity");
  visit("width", s.width, "width of the picture, pixels");
  visit("height", s.height, "height of the picture, pixels");
  visit("color",
        s.color,
        "cloud: what to color by: shape (median of the factors over all radii), "
        "height, gray (height in shades of gray), rgb, normal (of the surface in each "
        "pixel), shaded (that surface, lit), minor (points, lit by the smallest "
        "eigenvector of their tensor at --tensor-radius), or an attribute of the file");
  visit("curves",
        s.curves,
        "cloud: polylines to draw over it, in any format that linelet writes");
  visit("azimuth",
        s.azimuth,
        "cloud: direction of the eye, degrees clockwise from north");
  visit(
      "elevation", s.elevation, "cloud: elevation of the eye, degrees; 90: from above");
  visit("point-size", s.point_size, "cloud: diameter of points, pixels; 0: by density");
  visit("curve-width", s.curve_width, "cloud: width of curves, pixels");
  visit("fourth-order",
        s.fourth_order,
        "cloud as .svg: an ellipse at every point, the major eigentensor of its "
        "fourth-order tensor over all radii");
  describe(s.normals, visit);
  visit("tensor-radius",
        s.radius,
        "splats: radius of the tensors, in the unit of the cloud, also for ellipsoids "
        "and --color minor; 0: 4 D");
  visit("tensor-size",
        s.size,
        "splats: half of their length, in the unit of the cloud; 0: D");
  visit("tensors",
        s.tensors,
        "splats: draw the tensors in the file (attributes xx, xy, xz, yy, yz, zz) "
        "instead of those of the points");
  visit("splat-colors",
        s.splat_colors,
        "splats: colors of linear, planar and spherical tensors, and of cells");
  visit("cell-size",
        s.cell_size,
        "cells: edge of the cells, in the unit of the cloud; 0: 8 D. linelet cluster "
        "--mesh writes them to a file");
  visit("along", s.along, "profile: along the first curve of this file");
  visit("by-index", s.by_index, "profile: over the points, in the order of the file");
  visit("probe", s.probe, "profile: along the polyline x,y,z,x,y,z,...");
  visit("point",
        s.point,
        "draw graphs of the point nearest to x,y,z, or of the point with this number; "
        "with --kind profile: along its direction");
  visit("length",
        s.length,
        "length of a profile along the direction of a point, in the unit of the cloud; "
        "0: 30 D");
  visit("columns", s.columns, "profile: number of positions along the line");
  visit("rows", s.rows, "profile: number of radii, unless --radii gives them");
  visit("title", s.title, "title of the picture; empty: by its content");
}

/** \brief The points of \a cloud, colored as \a settings say.
 * \throws std::runtime_error if there is no such attribute */
Canvas
pictureOfCloud(const io::Cloud& cloud,
               const PictureSettings& settings,
               const MultiScaleSettings& shapes,
               const std::string& file,
               Frame& frame);

/** \brief The same as the text of an SVG file; see svg_picture.h. */
std::string
svgPictureOfCloud(const io::Cloud& cloud,
                  const PictureSettings& settings,
                  const MultiScaleSettings& shapes,
                  const std::string& file,
                  Frame& frame);

/** \brief The tensors of the points of \a cloud, as splats or ellipsoids. */
Canvas
pictureOfTensors(const io::Cloud& cloud,
                 const PictureSettings& settings,
                 const std::string& file,
                 Frame& frame);

/** \brief The cells of a grid in place of the points of \a cloud, as linelet cluster
 * finds them. */
Canvas
pictureOfCells(const io::Cloud& cloud,
               const PictureSettings& settings,
               const std::string& file,
               Frame& frame);

/** \brief The multi-scale feature image along the line given by \a settings. */
Canvas
pictureOfProfile(const io::Cloud& cloud,
                 const PictureSettings& settings,
                 const MultiScaleSettings& shapes,
                 const std::string& file,
                 Frame& frame);

/** \brief The graphs of the point given by \a settings. */
Canvas
pictureOfPoint(const io::Cloud& cloud,
               const PictureSettings& settings,
               const MultiScaleSettings& shapes,
               const std::string& file,
               Frame& frame);

} // namespace linelet::apps

namespace linelet {

template <>
struct Names<apps::PictureKind> {
  static constexpr std::string_view kind = "picture kind";
  static constexpr std::array<std::pair<apps::PictureKind, std::string_view>, 8> table =
      {{{apps::PictureKind::Cloud, "cloud"},
        {apps::PictureKind::Profile, "profile"},
        {apps::PictureKind::Graphs, "graphs"},
        {apps::PictureKind::Splats, "splats"},
        {apps::PictureKind::Ellipsoids, "ellipsoids"},
        {apps::PictureKind::CellSplats, "cell-splats"},
        {apps::PictureKind::CellQuads, "cell-quads"},
        {apps::PictureKind::CellBoxes, "cell-boxes"}}};
};

} // namespace linelet
