// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <linelet/io/point_file.h>
#include <linelet/io/usable_points.h>
#include <linelet/powerline/extract_power_lines.h>
#include <linelet/powerline/output_files.h>

#include "commands.h"
#include "frame.h"
#include "options.h"

namespace linelet::apps {

namespace {

using powerline::Clearance;
using powerline::PowerLineNetwork;
using powerline::Wire;

/** The smallest known clearance of one kind, and the wire that has it. */
std::pair<Clearance, int>
lowest(const PowerLineNetwork& network, Clearance Wire::*kind)
{
  std::pair<Clearance, int> result{{}, 0};
  for (const Wire& wire : network.wires) {
    const Clearance& c = wire.*kind;
    if (c.known() && !(c.distance >= result.first.distance))
      result = {c, wire.id};
  }
  return result;
}

void
printClearance(const char* name, const PowerLineNetwork& network, Clearance Wire::*kind)
{
  const auto [clearance, wire] = lowest(network, kind);
  if (clearance.known())
    std::printf("%-22s %.2f m (wire %d)\n", name, clearance.distance, wire);
}

nlohmann::ordered_json
toJson(const PowerLineNetwork& network, Clearance Wire::*kind)
{
  const auto [clearance, wire] = lowest(network, kind);
  if (!clearance.known())
    return nullptr;
  return {{"distance", clearance.distance}, {"wire", wire}};
}

/** Degrees, told or not, have no length that wires could be measured by. */
void
requireLengths(const io::Cloud& cloud, const io::Units& units, const std::string& path)
{
  const std::string help =
      ", and power lines are looked for in lengths; project it first, for example with "
      "pdal translate IN OUT.las reprojection "
      "--filters.reprojection.out_srs=EPSG:25832 "
      "(the code of your zone)";
  if (std::isnan(units.plan))
    throw io::FileError(path + ": its reference system " +
                        io::referenceName(cloud.wkt) + " has the unit " +
                        units.plan_name + help);
  // Degrees that no reference system tells of: next to no extent, but for the height.
  Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Point& p : cloud.points)
    if (p.allFinite()) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  const Point extent = high - low;
  const Point world = cloud.shift + low;
  if (cloud.wkt.empty() && cloud.points.size() > 1 &&
      extent.head<2>().maxCoeff() < 0.5 && extent.z() > 2 &&
      std::abs(world.x()) <= 360 && std::abs(world.y()) <= 90)
    throw io::FileError(path + ": its coordinates look like degrees" + help);
}

} // namespace

int
runPowerlines(const std::vector<std::string>& arguments)
{
  Frame frame("powerlines",
              "Find every wire of an airborne or UAV scan: classified cloud, vectors, "
              "report. Points flagged as withheld take no part and stay in the "
              "classified cloud as they are; overlap, synthetic and key points are "
              "used like others.");
  std::string in, folder;
  powerline::PowerLineSettings settings;
  io::ReadOptions reading;
  frame.app
      .add_option(
          "IN",
          in,
          "point file, z up, metres or feet (by its reference system); classes are not "
          "needed")
      ->required();
  frame.app
      .add_option("OUTDIR",
                  folder,
                  "folder for classified.las, wires.geojson, wires.gpkg, wires.dxf, "
                  "summary.json and report.html; made if need be")
      ->required();
  addOptions(frame.app, reading);
  addOptions(frame.app, settings);
  frame.parse(arguments);
  settings.threads = frame.threads;

  std::vector<std::string> warnings;
  io::Cloud cloud = io::readCloud(in, reading, &warnings, &frame.monitor);
  const io::Units units = io::unitsOf(cloud.wkt);
  requireLengths(cloud, units, in);
  if (!units.height_stated && !units.areMetres())
    warnings.push_back("the reference system tells no unit of heights; they count as " +
                       units.height_name + ", like x and y");
  if (cloud.wkt.empty())
    warnings.push_back(in +
                       " tells no reference system: its coordinates count as metres");
  const std::size_t withheld = io::UsablePoints(cloud, &warnings).withheld();
  powerline::makeOutputFolder(folder);
  const std::size_t points = cloud.points.size();
  const PowerLineNetwork network =
      powerline::extractPowerLines(cloud, settings, &frame.monitor);
  powerline::OutputOptions output;
  output.source = in.substr(in.find_last_of('/') + 1);
  output.clearance = settings.clearance;
  const std::vector<std::string> files = powerline::writePowerLineFiles(
      folder, std::move(cloud), network, output, &warnings, &frame.monitor);
  frame.warn(warnings);

  double length = 0;
  std::size_t hazards = 0, doubtful = 0;
  for (const Wire& wire : network.wires) {
    length += wire.length;
    hazards += powerline::belowClearance(wire, settings.clearance);
    doubtful += !wire.reason.empty();
  }
  if (network.wires.empty())
    std::printf("no wires found in %zu points\n", points);
  else {
    std::printf("%-22s %zu\n", "lines", network.circuits.size());
    std::printf("%-22s %zu\n", "spans", network.spans.size());
    std::printf("%-22s %zu (%.0f m, %zu of them with a remark)\n",
                "wires",
                network.wires.size(),
                length,
                doubtful);
    std::printf("%-22s %zu\n", "pylons and poles", network.supports.size());
    printClearance("lowest above ground", network, &Wire::ground);
    printClearance("nearest to vegetation", network, &Wire::vegetation);
    std::printf(
        "%-22s %zu wires below %.1f m\n", "clearance", hazards, settings.clearance);
  }
  for (const std::string& file : files)
    std::printf("%s\n", file.c_str());

  frame.summary["points"] = points;
  frame.summary["withheld"] = withheld;
  frame.summary["lines"] = network.circuits.size();
  frame.summary["spans"] = network.spans.size();
  frame.summary["wires"] = network.wires.size();
  frame.summary["length"] = length;
  frame.summary["supports"] = network.supports.size();
  frame.summary["ground_clearance"] = toJson(network, &Wire::ground);
  frame.summary["vegetation_clearance"] = toJson(network, &Wire::vegetation);
  frame.summary["wires_below_clearance"] = hazards;
  for (const powerline::StageTime& stage : network.stages)
    frame.summary["seconds"][stage.stage] = stage.seconds;
  frame.summary["files"] = files;
  frame.summary["warnings"] = warnings;
  return frame.finish();
}

} // namespace linelet::apps
