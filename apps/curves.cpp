// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <linelet/curves/reconstruct_curves.h>
#include <linelet/io/hdf5_file.h>
#include <linelet/io/output_check.h>
#include <linelet/io/vector_file.h>

#include "cloud_files.h"
#include "commands.h"
#include "frame.h"
#include "options.h"
#include "simplify_curves.h"

namespace linelet::apps {

namespace {

/** \brief Whether \a option was set to no avail, unless the preset is the published
 * one; an option file has all of them, most as they are anyway. */
bool
isOfPublishedPreset(const CLI::Option* option)
{
  return option->get_group() == "published" && option->count() > 0 &&
         option->results() != std::vector<std::string>{option->get_default_str()} &&
         !(option->get_expected_max() == 0 && option->as<std::string>() == "false");
}

bool
isHdf5(const std::string& path)
{
  return path.size() > 3 && path.compare(path.size() - 3, 3, ".h5") == 0;
}

/** \brief What the reconstruction says of each curve; what it cannot know is null. */
nlohmann::ordered_json
measuresOf(const CurveNetwork& network)
{
  auto result = nlohmann::ordered_json::array();
  for (const Curve& curve : network.curves)
    result.push_back({{"length", length(curve)},
                      {"closed", curve.closed},
                      {"noise", curve.noise},
                      {"density", curve.density},
                      {"evidence", curve.evidence}});
  return result;
}

} // namespace

int
runCurves(const std::vector<std::string>& arguments)
{
  Frame frame(
      "curves",
      "Reconstructs the curves that run through a point cloud: wires, edges, "
      "outlines. Written by ending: .obj .ply .vtk .csv in the coordinates of "
      "the input, .h5 with the points beside them, and .geojson (WGS 84) .gpkg .dxf "
      ".kml .fgb .shz or what else GDAL writes. Points flagged as withheld take no "
      "part.");
  ReconstructionSettings settings;
  std::string output;
  CloudInput input(frame);
  frame.addOutput("OUTPUT", output, "file for the curves");
  SimplifyTolerance simplify("auto");
  OptionAdder(frame.app)("simplify",
                         simplify,
                         "leave out vertices, as long as the curves stay within this "
                         "length; auto: a tenth of the noise of each; 0: none");
  addOptions(frame.app, settings);
  io::VectorOptions vectors;
  addOptions(frame.app, vectors);
  frame.parse(arguments);
  settings.threads = frame.threads;
  io::checkCurvesOutput(output);
  if (!isPublished(settings.preset))
    for (const CLI::Option* option : frame.app.get_options(isOfPublishedPreset))
      frame.warn(option->get_name() + " has no effect without --preset published");

  if (!isHdf5(output))
    input.readOnly({});
  const io::Cloud cloud = input.read();
  const io::UsablePoints usable = input.usable(cloud);
  // With those that take no part as NaN, so that --start counts as the file does.
  const Points& points = usable.points();
  const auto count = static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [](const Point& p) { return p.allFinite(); }));
  CurveNetwork network = reconstructCurves(points, settings, &frame.monitor);
  double tolerance = 0; // the largest
  for (const Curve& curve : network.curves)
    tolerance = std::max(tolerance, simplify.of(curve));
  network = simplified(std::move(network), simplify);
  frame.lap("curves");
  std::vector<std::string> warnings;
  if (isHdf5(output))
    io::writeHdf5(output, cloud, network, &frame.monitor);
  else
    io::writeCurves(
        output, network, cloud.shift, cloud.wkt, &warnings, &frame.monitor, vectors);
  frame.warn(warnings);
  frame.lap("write");

  const auto closed = static_cast<std::size_t>(
      std::count_if(network.curves.begin(), network.curves.end(), [](const Curve& c) {
        return c.closed;
      }));
  if (network.curves.empty())
    frame.warn("no curve found in the " + std::to_string(count) +
               " points; the output is empty");
  std::printf(
      "%s: %zu curves (%zu closed), %zu junctions, length %.6g, from %zu points\n",
      output.c_str(),
      network.curves.size(),
      closed,
      network.junctions.size(),
      length(network),
      count);
  frame.summary["points"] = count;
  frame.summary["withheld"] = usable.withheld();
  frame.summary["ignored"] = usable.ignored();
  frame.summary["curves"] = network.curves.size();
  frame.summary["closed"] = closed;
  frame.summary["junctions"] = network.junctions.size();
  frame.summary["vertices"] = std::accumulate(
      network.curves.begin(),
      network.curves.end(),
      std::size_t{0},
      [](std::size_t sum, const Curve& c) { return sum + c.points.size(); });
  frame.summary["simplify_tolerance"] = tolerance;
  frame.summary["length"] = length(network);
  frame.summary["measures"] = measuresOf(network);
  return frame.finish();
}

} // namespace linelet::apps
