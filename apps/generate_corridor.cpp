// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <bench/scenes/corridor.h>
#include <linelet/io/output_check.h>
#include <linelet/io/vector_file.h>

#include "cloud_files.h"
#include "commands.h"
#include "frame.h"
#include "options.h"
#include "utm_32.h"

namespace linelet::apps {

namespace {

io::Cloud
toCloud(bench::CorridorScan& scan)
{
  io::Cloud cloud;
  cloud.shift = scan.shift;
  cloud.points = std::move(scan.points);
  cloud.wkt = utm_32;
  cloud.set({"intensity", std::move(scan.intensity), ""});
  cloud.set({"return_number", std::move(scan.return_number), ""});
  cloud.set({"number_of_returns", std::move(scan.number_of_returns), ""});
  cloud.set({"classification", std::move(scan.classification), ""});
  cloud.set({"scan_angle", std::move(scan.scan_angle), ""});
  cloud.set({"point_source_id", std::move(scan.strip), ""});
  cloud.set({"gps_time", std::move(scan.gps_time), ""});
  return cloud;
}

CurveNetwork
toNetwork(const std::vector<bench::CorridorWire>& wires)
{
  CurveNetwork network;
  for (const bench::CorridorWire& wire : wires) {
    Curve curve;
    curve.points = wire.points;
    network.curves.push_back(std::move(curve));
  }
  return network;
}

io::VectorLayer
plantedLayer(const std::vector<bench::PlantedHazard>& planted, const Point& shift)
{
  io::VectorLayer layer{"planted", io::VectorLayer::Kind::Points, {}, {}};
  layer.columns = {{"class", std::int64_t(0)}, {"distance", 0.0}};
  for (const bench::PlantedHazard& hazard : planted)
    layer.features.push_back({{hazard.wire + shift},
                              {{"class", std::int64_t(hazard.classification)},
                               {"distance", hazard.distance}},
                              "",
                              ""});
  return layer;
}

} // namespace

int
runGenerateCorridor(const std::vector<std::string>& arguments)
{
  Frame frame(
      "generate corridor",
      "Simulates an airborne scan of a power line corridor: terrain, trees, "
      "houses, cranes, fences, a high-voltage line and pole lines below it. The "
      "classes in the file are the truth (14 wire, 15 pylon, pole or insulator).");
  bench::CorridorSettings settings;
  std::string truth, planted;
  CloudOutput output(frame, CloudOutput::Inputs::None);
  OptionAdder(frame.app)(
      "truth", truth, "file for the true wires, one polyline per span");
  OptionAdder(frame.app)("planted-truth",
                         planted,
                         "file (.csv, .geojson, .gpkg, .dxf) for what --planted put "
                         "too close to wires, as points on the wires");
  frame.writes(truth);
  frame.writes(planted);
  addOptions(frame.app, settings);
  frame.parse(arguments);
  output.check();
  if (!truth.empty())
    io::checkCurvesOutput(truth);

  bench::CorridorScan scan = bench::simulateCorridor(settings, &frame.monitor);
  std::map<int, std::size_t> classes;
  for (const std::uint8_t c : scan.classification)
    ++classes[c];
  const CurveNetwork network = toNetwork(scan.wires);
  const io::Cloud cloud = toCloud(scan);
  frame.lap("generate");
  output.write(cloud);
  if (!planted.empty())
    io::writeLayers(planted, {plantedLayer(scan.planted, cloud.shift)}, cloud.wkt);
  if (!truth.empty())
    io::writeCurves(truth, network, cloud.shift, cloud.wkt, nullptr, &frame.monitor);

  std::printf("%s: %zu points, %zu of them on %zu wires of %.0f m\n",
              output.path().c_str(),
              cloud.points.size(),
              classes[14],
              network.curves.size(),
              length(network));
  frame.summary["points"] = cloud.points.size();
  frame.summary["wires"] = network.curves.size();
  frame.summary["wire_length"] = length(network);
  for (const auto& [name, count] : classes)
    frame.summary["classes"][std::to_string(name)] = count;
  return frame.finish();
}

} // namespace linelet::apps
