// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <bench/scenes/scene.h>
#include <linelet/io/output_check.h>
#include <linelet/io/vector_file.h>

#include "cloud_files.h"
#include "commands.h"
#include "frame.h"
#include "options.h"
#include "utm_32.h"

namespace linelet::apps {

namespace {

CurveNetwork
wireNetwork(const bench::SceneScan& scan)
{
  CurveNetwork network;
  for (const bench::SceneWire& wire : scan.wires) {
    Curve curve;
    curve.points = wire.points;
    network.curves.push_back(std::move(curve));
  }
  return network;
}

CurveNetwork
structureNetwork(const bench::SceneScan& scan)
{
  CurveNetwork network;
  for (const bench::SceneStructure& structure : scan.structures) {
    Curve curve;
    curve.points = {structure.from, structure.to};
    network.curves.push_back(std::move(curve));
  }
  return network;
}

/** What a scorer needs to know about every wire, in the order of the truth file. */
nlohmann::ordered_json
describeWires(const bench::SceneScan& scan)
{
  auto list = nlohmann::ordered_json::array();
  for (const bench::SceneWire& wire : scan.wires)
    list.push_back({{"line", wire.line},
                    {"span", wire.span},
                    {"number", wire.number},
                    {"conductors", wire.conductors},
                    {"bundle_radius", wire.bundle_radius},
                    {"noise", wire.noise}});
  return list;
}

} // namespace

int
runGenerateScene(const std::vector<std::string>& arguments)
{
  Frame frame("generate scene",
              "Simulates an airborne scan of one of many kinds of scenes, with and "
              "without power lines. The classes in the file are the truth: 14 wire, 15 "
              "pylon or pole, 16 insulator, 5 vegetation, 6 building, 2 ground, 1 "
              "crane, gantry, pipe, guy, fence, rail.");
  bench::SceneSettings settings;
  std::string truth, structures, names;
  for (const auto& entry : Names<bench::SceneKind>::table)
    names += (names.empty() ? ": " : ", ") + std::string(entry.second);
  const OptionAdder add(frame.app);
  add.argument("NAME", settings.kind, "the scene" + names);
  CloudOutput output(frame, CloudOutput::Inputs::None);
  add("truth", truth, "file for the true wires, one polyline per span; bundles as one");
  add("structures",
      structures,
      "file for everything else that is long and thin, piece by piece");
  frame.writes(truth);
  frame.writes(structures);
  addOptions(frame.app, settings);
  frame.parse(arguments);
  output.check();
  for (const std::string& file : {truth, structures})
    if (!file.empty())
      io::checkCurvesOutput(file);

  bench::SceneScan scan = bench::simulateScene(settings, &frame.monitor);
  std::map<int, std::size_t> classes;
  for (const std::uint8_t c : scan.classification)
    ++classes[c];
  const CurveNetwork wires = wireNetwork(scan);
  io::Cloud cloud;
  cloud.shift = scan.shift;
  cloud.points = std::move(scan.points);
  cloud.wkt = utm_32;
  cloud.set({"return_number", std::move(scan.return_number), ""});
  cloud.set({"number_of_returns", std::move(scan.number_of_returns), ""});
  cloud.set({"classification", std::move(scan.classification), ""});
  cloud.set({"point_source_id", std::move(scan.strip), ""});
  frame.lap("generate");
  output.write(cloud);
  if (!truth.empty())
    io::writeCurves(truth, wires, cloud.shift, cloud.wkt, nullptr, &frame.monitor);
  if (!structures.empty())
    io::writeCurves(structures,
                    structureNetwork(scan),
                    cloud.shift,
                    cloud.wkt,
                    nullptr,
                    &frame.monitor);

  std::printf("%s: %zu points, %zu of them on %zu wires of %.0f m\n",
              output.path().c_str(),
              cloud.points.size(),
              classes[14],
              wires.curves.size(),
              length(wires));
  frame.summary["scene"] = std::string(nameOf(settings.kind));
  frame.summary["seed"] = settings.seed;
  frame.summary["points"] = cloud.points.size();
  frame.summary["density"] = scan.density;
  frame.summary["noise"] = scan.noise;
  frame.summary["wire_length"] = length(wires);
  for (const auto& [name, count] : classes)
    frame.summary["classes"][std::to_string(name)] = count;
  frame.summary["wires"] = describeWires(scan);
  return frame.finish();
}

} // namespace linelet::apps
