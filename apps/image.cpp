// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include <linelet/io/output_file.h>

#include "cloud_files.h"
#include "commands.h"
#include "frame.h"
#include "given_tensors.h"
#include "options.h"
#include "picture/canvas.h"
#include "picture/pictures.h"

namespace linelet::apps {

namespace {

Canvas
draw(const io::Cloud& cloud,
     const PictureSettings& settings,
     const MultiScaleSettings& shapes,
     const std::string& file,
     Frame& frame)
{
  switch (settings.kind) {
  case PictureKind::Profile:
    return pictureOfProfile(cloud, settings, shapes, file, frame);
  case PictureKind::Graphs:
    return pictureOfPoint(cloud, settings, shapes, file, frame);
  case PictureKind::Splats:
  case PictureKind::Ellipsoids:
    return pictureOfTensors(cloud, settings, file, frame);
  case PictureKind::CellSplats:
  case PictureKind::CellQuads:
  case PictureKind::CellBoxes:
    return pictureOfCells(cloud, settings, file, frame);
  case PictureKind::Cloud:
    break;
  }
  return pictureOfCloud(cloud, settings, shapes, file, frame);
}

/** Whether the points are to be colored by an attribute of that name. */
bool
isAttribute(const std::string& color)
{
  constexpr std::string_view others[] = {
      "shape", "height", "gray", "rgb", "normal", "shaded", "minor"};
  return std::find(std::begin(others), std::end(others), color) == std::end(others);
}

bool
isSvg(const std::string& path)
{
  return path.size() > 4 && path.compare(path.size() - 4, 4, ".svg") == 0;
}

} // namespace

int
runImage(const std::vector<std::string>& arguments)
{
  Frame frame(
      "image",
      "Draws a picture, without a display: the cloud from any side, with curves over "
      "it; a multi-scale feature image, whose columns are positions along a line and "
      "whose rows are radii; the tensors of the points, as splats that fade where they "
      "are spherical, or as ellipsoids; the cells of a grid, as splats, planes or "
      "boxes; or the graphs of linearity, planarity and sphericity of one point over "
      "the radius, with extrema and optimal radius. Clouds and curves can also be "
      "drawn as .svg (from above with --elevation 90, otherwise in perspective). "
      "Coordinates on the command line are those of the file. Points flagged as "
      "withheld are not drawn.");
  PictureSettings settings;
  MultiScaleSettings shapes;
  shapes.centroid = Centroid::Median;
  std::string output;
  CloudInput input(frame);
  frame.addOutput("OUTPUT", output, "picture, .png or .svg");
  frame.reads(settings.curves);
  frame.reads(settings.along);
  addOptions(frame.app, settings);
  addOptions(frame.app, shapes);
  frame.parse(arguments);
  shapes.threads = frame.threads;
  // Compares values, since an option file lists every default.
  if (settings.kind == PictureKind::Cloud) {
    if (!settings.along.empty() || !settings.probe.empty() || settings.by_index)
      settings.kind = PictureKind::Profile;
    else if (!settings.point.empty())
      settings.kind = PictureKind::Graphs;
  }
  // Medians for all neighborhoods of a cloud are slow.
  if (settings.kind == PictureKind::Cloud && frame.app.count("--centroid") == 0)
    shapes.centroid = Centroid::QueryPoint;
  const bool svg = isSvg(output);
  if (svg && settings.kind != PictureKind::Cloud)
    throw std::runtime_error(output +
                             ": only clouds and curves are drawn as .svg; name a .png");
  if (settings.fourth_order && !svg)
    throw std::runtime_error("--fourth-order draws ellipses; name a .svg instead of " +
                             output);
  if (svg)
    io::checkWritable(output);
  else
    checkPictureOutput(output);
  constexpr unsigned least = 200, most = 10000;
  if (settings.width < least || settings.height < least || settings.width > most ||
      settings.height > most)
    throw std::runtime_error("width and height must be between 200 and 10000 pixels");

  if (settings.kind != PictureKind::Cloud || !isAttribute(settings.color))
    input.readOnly(settings.tensors ? tensorAttributes()
                   : settings.color == "rgb"
                       ? std::vector<std::string>{"red", "green", "blue"}
                       : std::vector<std::string>{});
  io::Cloud cloud = input.read();
  if (const auto usable = input.usable(cloud); usable.leftOut() > 0)
    cloud.points = usable.points();
  if (cloud.points.empty())
    throw std::runtime_error(input.path() + ": there are no points to draw");
  if (svg) {
    io::OutputFile file(output);
    file.write(svgPictureOfCloud(cloud, settings, shapes, input.path(), frame));
    file.commit();
  }
  else
    draw(cloud, settings, shapes, input.path(), frame).save(output);
  frame.lap("image");
  std::printf("%s: %s, %u x %u pixels\n",
              output.c_str(),
              std::string(nameOf(settings.kind)).c_str(),
              settings.width,
              settings.height);
  frame.summary["kind"] = nameOf(settings.kind);
  frame.summary["points"] = cloud.points.size();
  return frame.finish();
}

} // namespace linelet::apps
