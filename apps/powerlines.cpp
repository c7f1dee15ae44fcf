// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include <linelet/powerline/extract_power_lines.h>
#include <linelet/powerline/hazards.h>
#include <linelet/powerline_output/output_files.h>
#include <linelet/powerline_output/review_file.h>

#include "cloud_files.h"
#include "commands.h"
#include "frame.h"
#include "options.h"
#include "run_date.h"
#include "version.h"

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

void
refuseOtherResults(const std::string& folder,
                   const io::Cloud& cloud,
                   const std::string& source,
                   bool overwrite)
{
  const std::string other = powerline::otherResultsIn(folder, cloud, source);
  if (!other.empty() && !overwrite)
    throw io::FileError(folder + ": holds the results of " + other +
                        "; name another folder, or replace them with --overwrite");
}

/** \brief What the wires of a network come to. */
struct Totals {
  double length = 0;        ///< meters
  std::size_t hazards = 0;  ///< wires with less clearance than is in order
  std::size_t doubtful = 0; ///< wires with a remark
};

Totals
totalsOf(const PowerLineNetwork& network, double clearance)
{
  Totals totals;
  for (const Wire& wire : network.wires) {
    totals.length += wire.length;
    totals.hazards += powerline::belowClearance(wire, clearance) ? 1 : 0;
    totals.doubtful += wire.reason.empty() ? 0 : 1;
  }
  return totals;
}

void
print(const PowerLineNetwork& network, const Totals& totals, double clearance)
{
  std::printf("%-22s %zu\n", "lines", network.circuits.size());
  std::printf("%-22s %zu\n", "spans", network.spans.size());
  std::printf("%-22s %zu (%.0f m, %zu of them with a remark)\n",
              "wires",
              network.wires.size(),
              totals.length,
              totals.doubtful);
  std::printf("%-22s %zu\n", "pylons and poles", network.supports.size());
  std::printf("%-22s %zu (%.0f m)\n",
              "unexplained lines",
              network.unexplained.size(),
              unexplainedLength(network));
  printClearance("lowest above ground", network, &Wire::ground);
  printClearance("nearest to vegetation", network, &Wire::vegetation);
  std::printf("%-22s %zu wires below %.1f m\n", "clearance", totals.hazards, clearance);
}

void
print(const powerline::Hazards& hazards)
{
  std::size_t high = 0;
  for (const powerline::Encroachment& one : hazards.clearances)
    high += one.severity == powerline::Severity::High ? 1 : 0;
  std::printf("%-22s %zu hazards (%zu severe), %zu trees that could fall in, %zu "
              "crossings\n",
              hazards.state.c_str(),
              hazards.clearances.size(),
              high,
              hazards.fall_in.size(),
              hazards.crossings.size());
}

void
summarize(nlohmann::ordered_json& summary,
          const PowerLineNetwork& network,
          const Totals& totals)
{
  summary["lines"] = network.circuits.size();
  summary["spans"] = network.spans.size();
  summary["wires"] = network.wires.size();
  summary["length"] = totals.length;
  summary["supports"] = network.supports.size();
  summary["unexplained_lines"] = network.unexplained.size();
  summary["unexplained_length"] = unexplainedLength(network);
  summary["ground_clearance"] = toJson(network, &Wire::ground);
  summary["vegetation_clearance"] = toJson(network, &Wire::vegetation);
  summary["wires_below_clearance"] = totals.hazards;
  for (const powerline::StageTime& stage : network.stages)
    summary["stage_seconds"][stage.stage] = stage.seconds;
}

} // namespace

int
runPowerlines(const std::vector<std::string>& arguments)
{
  Frame frame("powerlines",
              "Finds every wire of an airborne or UAV scan: classified cloud, vectors, "
              "report. Points flagged as withheld take no part and stay in the "
              "classified cloud as they are; overlap, synthetic and key points are "
              "used like others.");
  std::string folder;
  powerline::PowerLineSettings settings;
  powerline::OutputOptions output;
  bool overwrite = false;
  CloudInput input(frame,
                   CloudInput::Use::Lengths,
                   "point file, z up, meters or feet (by its reference system); "
                   "classes are not needed");
  frame.addOutput("OUTDIR",
                  folder,
                  "folder for classified.las or .laz, wires and hazards as .geojson, "
                  ".gpkg and .dxf, clearances.csv, crossings.csv, fall_in.csv, "
                  "summary.json and report.html; made if need be");
  addOptions(frame.app, settings);
  powerline::HazardSettings hazards;
  addOptions(frame.app, hazards);
  frame.reads(hazards.limits);
  frame.reads(hazards.conductor);
  addOptions(frame.app, output.classes);
  addOptions(frame.app, output.vectors);
  OptionAdder(frame.app)(
      "overwrite", overwrite, "replace results of another input in OUTDIR");
  std::string reviewed;
  OptionAdder(frame.app)(
      "reviewed",
      reviewed,
      "wires that somebody judged, in linelet-view or a GIS (columns review, "
      "review_class, review_note of this file): rejected ones are left out, accepted "
      "ones certain");
  frame.reads(reviewed);
  std::string classified = "as input";
  frame.app.add_option("--classified", classified, "ending of the classified cloud")
      ->check(CLI::IsMember({"as input", "las", "laz"}))
      ->type_name("NAME")
      ->group("Options");
  frame.parse(arguments);
  const std::string first = input.files().front();
  output.compress = classified == "laz" || (classified != "las" && first.size() > 4 &&
                                            (first.substr(first.size() - 4) == ".laz" ||
                                             first.substr(first.size() - 4) == ".LAZ"));
  frame.checkOutputs(powerline::powerLineFiles(folder, output.compress));
  check(output.classes);
  settings.threads = frame.threads;
  powerline::check(hazards);

  io::Cloud cloud = input.read();
  output.source = std::filesystem::path(input.path()).filename().string();
  output.provenance = {
      "linelet " LINELET_VERSION, runDate(), input.files(), frame.settings()};
  refuseOtherResults(folder, cloud, output.source, overwrite);
  powerline::makeOutputFolder(folder, output.compress);
  const io::Units units = io::unitsOf(cloud.wkt);
  if (!units.height_stated && !units.areMeters())
    frame.warn("the reference system tells no unit of heights; they count as " +
               units.height_name + ", like x and y");
  if (cloud.wkt.empty())
    frame.warn(input.path() +
               " tells no reference system: its coordinates count as meters");
  settings.points = output.points = input.classes();
  const io::UsablePoints usable = input.usable(cloud);
  const std::size_t withheld = usable.withheld(), ignored = usable.ignored();
  const std::size_t points = cloud.points.size();
  const auto judged = reviewed.empty() ? std::vector<powerline::ReviewedWire>()
                                       : powerline::readReview(reviewed, cloud);
  PowerLineNetwork network =
      powerline::extractPowerLines(cloud, settings, &frame.monitor);
  for (const std::string& sentence : powerline::applyReview(network, judged))
    frame.warn(reviewed + ": " + sentence);
  output.clearance = settings.clearance;
  frame.lap("powerlines");
  frame.monitor.begin("hazards", 0);
  output.hazards = powerline::findHazardsAtStates(network,
                                                  cloud,
                                                  usable,
                                                  hazards,
                                                  settings.clearance,
                                                  frame.threads,
                                                  &frame.monitor);
  frame.lap("hazards");
  std::vector<std::string> warnings;
  const std::vector<std::string> files = powerline::writePowerLineFiles(
      folder, std::move(cloud), network, output, &warnings, &frame.monitor);
  frame.warn(warnings);
  frame.lap("write");

  const Totals totals = totalsOf(network, settings.clearance);
  if (network.wires.empty())
    std::printf("no wires found in %zu points\n", points);
  else {
    print(network, totals, settings.clearance);
    for (const powerline::Hazards& state : output.hazards)
      print(state);
  }
  for (const std::string& file : files)
    std::printf("%s\n", file.c_str());

  frame.summary["points"] = points;
  frame.summary["withheld"] = withheld;
  frame.summary["ignored"] = ignored;
  summarize(frame.summary, network, totals);
  for (const powerline::Hazards& state : output.hazards)
    frame.summary["hazards"].push_back({{"state", state.state},
                                        {"clearances", state.clearances.size()},
                                        {"crossings", state.crossings.size()},
                                        {"fall_in", state.fall_in.size()}});
  frame.summary["files"] = files;
  return frame.finish();
}

} // namespace linelet::apps
