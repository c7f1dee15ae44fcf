// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <linelet/curves/reconstruct_curves.h>
#include <linelet/io/output_check.h>
#include <linelet/io/vector_file.h>

#include "cloud_files.h"
#include "commands.h"
#include "frame.h"
#include "options.h"

namespace linelet::apps {

namespace {

/** \brief The usable points of \a cloud whose class is one of \a classes, of any class
 * if none is named. */
Points
choosePoints(const io::Cloud& cloud,
             const io::UsablePoints& usable,
             const std::vector<int>& classes,
             const std::string& file)
{
  const io::Column* column = cloud.find("classification");
  if (column == nullptr && !classes.empty())
    throw std::runtime_error(file +
                             ": its points have no classes; leave out --classes");
  const auto isOfClass = [&](std::size_t i) {
    const int number = static_cast<int>(io::valueAt(*column, i));
    return std::find(classes.begin(), classes.end(), number) != classes.end();
  };
  Points chosen;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (usable.points()[i].allFinite() && (classes.empty() || isOfClass(i)))
      chosen.push_back(usable.points()[i]);
  return chosen;
}

/** \brief Whether \a option was set to no avail, unless the preset is the published
 * one; an option file has all of them, most as they are anyway. */
bool
isOfPublishedPreset(const CLI::Option* option)
{
  return option->get_group() == "published" && option->count() > 0 &&
         option->results() != std::vector<std::string>{option->get_default_str()};
}

} // namespace

int
runCurves(const std::vector<std::string>& arguments)
{
  Frame frame(
      "curves",
      "Reconstructs the curves that run through a point cloud: wires, edges, "
      "outlines. Written by ending: .obj .ply .vtk .csv .geojson .gpkg .dxf, in "
      "the coordinates of the input. Points flagged as withheld take no part.");
  ReconstructionSettings settings;
  std::string output;
  std::vector<int> classes;
  CloudInput input(frame);
  frame.app.add_option("OUTPUT", output, "file for the curves")->required();
  frame.app
      .add_option("--classes", classes, "only points of these classes, such as 14,15")
      ->delimiter(',')
      ->type_name("N,...");
  addOptions(frame.app, settings);
  frame.parse(arguments);
  settings.threads = frame.threads;
  io::checkCurvesOutput(output);
  if (settings.preset != Preset::Published)
    for (const CLI::Option* option : frame.app.get_options(isOfPublishedPreset))
      frame.warn(option->get_name() + " has no effect without --preset published");

  const io::Cloud cloud = input.read();
  const io::UsablePoints usable = usablePoints(cloud, frame);
  const Points points = choosePoints(cloud, usable, classes, input.path());
  const CurveNetwork network = reconstructCurves(points, settings, &frame.monitor);
  frame.lap("curves");
  std::vector<std::string> warnings;
  io::writeCurves(output, network, cloud.shift, cloud.wkt, &warnings);
  frame.warn(warnings);
  frame.lap("write");

  const auto closed = static_cast<std::size_t>(
      std::count_if(network.curves.begin(), network.curves.end(), [](const Curve& c) {
        return c.closed;
      }));
  if (points.empty() && !classes.empty())
    frame.warn(input.path() + ": no point is of a class of --classes; linelet info "
                              "lists those it has");
  else if (network.curves.empty())
    frame.warn("no curve found in the " + std::to_string(points.size()) +
               " points; the output is empty");
  std::printf(
      "%s: %zu curves (%zu closed), %zu junctions, length %.6g, from %zu points\n",
      output.c_str(),
      network.curves.size(),
      closed,
      network.junctions.size(),
      length(network),
      points.size());
  frame.summary["points"] = points.size();
  frame.summary["withheld"] = usable.withheld();
  frame.summary["curves"] = network.curves.size();
  frame.summary["closed"] = closed;
  frame.summary["junctions"] = network.junctions.size();
  frame.summary["length"] = length(network);
  return frame.finish();
}

} // namespace linelet::apps
