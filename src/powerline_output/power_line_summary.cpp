// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline_output/power_line_summary.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include <linelet/powerline/metric_frame.h>
#include <linelet/powerline_output/below_clearance.h>
#include <linelet/powerline_output/result_files.h>

#include "hazard_summary.h"

namespace linelet::powerline {

namespace {

using Json = nlohmann::ordered_json;

/** Rounded to a tenth of a millimeter, so that files can be compared; null: unknown. */
Json
number(double value)
{
  return std::isfinite(value) ? Json(std::round(value * 1e4) / 1e4) : Json(nullptr);
}

Json
place(const Point& p, const MetricFrame& frame)
{
  const Point world = frame.world(p);
  return Json::array({number(world.x()), number(world.y()), number(world.z())});
}

/** The id of something that may not exist. */
Json
identity(int id)
{
  return id > 0 ? Json(id) : Json(nullptr);
}

Json
identities(const std::vector<int>& ids)
{
  Json all = Json::array();
  for (const int id : ids)
    all.push_back(identity(id));
  return all;
}

Json
clearance(const Clearance& found, const MetricFrame& frame)
{
  if (!found.known())
    return nullptr;
  return {{"distance", number(found.distance)},
          {"at", place(found.wire, frame)},
          {"to", place(found.other, frame)}};
}

Json
review(const Review& review)
{
  if (review.empty())
    return nullptr;
  return {{"verdict", std::string(nameOf(review.verdict))},
          {"class", review.point_class < 0 ? Json(nullptr) : Json(review.point_class)},
          {"note", review.note}};
}

Json
wireJson(const Wire& wire, const MetricFrame& frame, const OutputOptions& options)
{
  return {{"wire_id", wire.id},
          {"span_id", wire.span},
          {"circuit", wire.circuit},
          {"wire_number", wire.number},
          {"conductors", wire.conductors},
          {"from_pylon", identity(wire.front_support)},
          {"to_pylon", identity(wire.back_support)},
          {"from", place(wire.front, frame)},
          {"to", place(wire.back, frame)},
          {"length", number(wire.length)},
          {"span_length", number(wire.span_length)},
          {"sag", number(wire.sag)},
          {"catenary",
           {{"a", number(wire.curve.a)},
            {"azimuth", number(wire.curve.azimuth)},
            {"swing", number(wire.curve.swing)},
            {"lowest", place(wire.curve.lowest, frame)}}},
          {"ground_clearance", clearance(wire.ground, frame)},
          {"vegetation_clearance", clearance(wire.vegetation, frame)},
          {"below_clearance", belowClearance(wire, options.clearance)},
          {"points", wire.points},
          {"rms", number(wire.rms)},
          {"largest_gap", number(wire.largest_gap)},
          {"confidence", number(wire.confidence)},
          {"reason", wire.reason},
          {"review", review(wire.review)}};
}

Json
jumperJson(const Jumper& jumper, const MetricFrame& frame)
{
  Json course = Json::array();
  for (const Point& p : jumper.course)
    course.push_back(place(p, frame));
  return {{"jumper_id", jumper.id},
          {"kind", "jumper"},
          {"pylon_id", identity(jumper.support)},
          {"from_wire", identity(jumper.from_wire)},
          {"to_wire", identity(jumper.to_wire)},
          {"length", number(jumper.length)},
          {"sag", number(jumper.sag)},
          {"points", jumper.points},
          {"rms", number(jumper.rms)},
          {"course", std::move(course)}};
}

Json
insulatorJson(const InsulatorString& string, const MetricFrame& frame)
{
  return {{"insulator_id", string.id},
          {"kind", std::string(nameOf(string.kind))},
          {"pylon_id", identity(string.support)},
          {"wire_id", identity(string.wire)},
          {"jumper_id", identity(string.jumper)},
          {"length", number(string.length)},
          {"points", string.points},
          {"structure", place(string.structure, frame)},
          {"live", place(string.live, frame)}};
}

Json
totals(const PowerLineNetwork& network, const OutputOptions& options)
{
  double length = 0;
  std::size_t doubtful = 0, poles = 0, wire_points = 0, pylon_points = 0;
  for (const Wire& wire : network.wires) {
    length += wire.length;
    doubtful += wire.reason.empty() ? 0 : 1;
  }
  for (const Support& support : network.supports) {
    poles += support.kind == Support::Kind::Pole ? 1 : 0;
    pylon_points += support.points;
  }
  double jumper_length = 0;
  std::size_t jumper_points = 0, insulator_points = 0;
  for (const Jumper& jumper : network.jumpers) {
    jumper_length += jumper.length;
    jumper_points += jumper.points;
  }
  for (const InsulatorString& string : network.insulators)
    insulator_points += string.points;
  std::size_t unexplained_points = 0;
  for (const UnexplainedLine& line : network.unexplained)
    unexplained_points += line.points;
  for (const std::int32_t id : network.wire_id)
    wire_points += id > 0 ? 1 : 0;
  const auto below = wiresBelowClearance(network, options.clearance);
  return {{"circuits", network.circuits.size()},
          {"spans", network.spans.size()},
          {"wires", network.wires.size()},
          {"pylons", network.supports.size() - poles},
          {"poles", poles},
          {"jumpers", network.jumpers.size()},
          {"insulators", network.insulators.size()},
          {"wire_length", number(length)},
          {"jumper_length", number(jumper_length)},
          {"wire_points", wire_points},
          {"pylon_points", pylon_points},
          {"jumper_points", jumper_points},
          {"insulator_points", insulator_points},
          {"wires_below_clearance", below ? Json(*below) : Json()},
          {"wires_of_low_confidence", doubtful},
          {"unexplained_lines", network.unexplained.size()},
          {"unexplained_length", number(unexplainedLength(network))},
          {"unexplained_points", unexplained_points}};
}

InputExtent
extentOf(const io::Cloud& cloud)
{
  InputExtent input;
  input.points = cloud.points.size();
  input.low = Point::Constant(std::numeric_limits<double>::infinity());
  input.high = -input.low;
  for (const Point& p : cloud.points)
    if (p.allFinite()) {
      input.low = input.low.cwiseMin(p);
      input.high = input.high.cwiseMax(p);
    }
  input.low += cloud.shift;
  input.high += cloud.shift;
  return input;
}

/** What identifies an input. */
Json
identityOf(const InputExtent& input, const std::string& source)
{
  const auto corner = [](const Point& p) {
    return Json::array({number(p.x()), number(p.y()), number(p.z())});
  };
  return {
      {"source", source},
      {"points", input.points},
      {"bounds", {{"minimum", corner(input.low)}, {"maximum", corner(input.high)}}}};
}

} // namespace

std::string
otherResultsIn(const std::string& folder,
               const io::Cloud& cloud,
               const std::string& source)
{
  return otherResultsIn(folder, extentOf(cloud), source);
}

std::string
otherResultsIn(const std::string& folder,
               const InputExtent& input,
               const std::string& source)
{
  std::vector<std::string> files = powerLineFiles(folder);
  files.push_back(powerLineFiles(folder, true).front());
  std::error_code ignored;
  if (std::none_of(files.begin(), files.end(), [&](const std::string& file) {
        return std::filesystem::exists(file, ignored);
      }))
    return {};
  constexpr const char* unknown = "an unknown input";
  std::ifstream in(std::filesystem::path(folder) / "summary.json");
  const Json there = Json::parse(in, nullptr, false);
  if (!there.is_object() || !there.contains("source") || !there["source"].is_string())
    return unknown;
  // Summaries of earlier versions have fewer keys.
  const Json here = identityOf(input, source);
  for (const auto& [key, value] : here.items())
    if (there.contains(key) && there[key] != value) {
      const auto name = there["source"].get<std::string>();
      return name == source ? "another " + name : name.empty() ? unknown : name;
    }
  return {};
}

std::string
powerLineSummary(const io::Cloud& cloud,
                 const PowerLineNetwork& network,
                 const OutputOptions& options)
{
  const MetricFrame frame(cloud);
  const io::Units& units = frame.units();
  Json summary =
      identityOf(options.input ? *options.input : extentOf(cloud), options.source);
  summary.update({{"reference_system", io::referenceName(cloud.wkt)},
                  {"units",
                   {{"lengths", "metre"},
                    {"coordinates", units.plan_name},
                    {"heights_in_coordinates", units.height_name}}},
                  {"clearance_limit", number(options.clearance)},
                  {"totals", totals(network, options)}});
  Json circuits = Json::array(), spans = Json::array(), wires = Json::array(),
       pylons = Json::array(), jumpers = Json::array(), insulators = Json::array();
  for (const Circuit& circuit : network.circuits)
    circuits.push_back({{"circuit", circuit.id},
                        {"spans", identities(circuit.spans)},
                        {"pylons", identities(circuit.supports)}});
  for (const Span& span : network.spans)
    spans.push_back({{"span_id", span.id},
                     {"circuit", span.circuit},
                     {"span_number", span.number},
                     {"from_pylon", identity(span.from_support)},
                     {"to_pylon", identity(span.to_support)},
                     {"length", number(span.length)},
                     {"azimuth", number(span.azimuth)},
                     {"wires", span.wires}});
  for (const Wire& wire : network.wires)
    wires.push_back(wireJson(wire, frame, options));
  for (const Support& support : network.supports)
    pylons.push_back({{"pylon_id", support.id},
                      {"kind", support.kind == Support::Kind::Pole ? "pole" : "pylon"},
                      {"base", place(support.base, frame)},
                      {"height", number(support.height)},
                      {"points", support.points},
                      {"confidence", number(support.confidence)}});
  for (const Jumper& jumper : network.jumpers)
    jumpers.push_back(jumperJson(jumper, frame));
  for (const InsulatorString& string : network.insulators)
    insulators.push_back(insulatorJson(string, frame));
  summary["circuits"] = std::move(circuits);
  summary["spans"] = std::move(spans);
  summary["wires"] = std::move(wires);
  summary["pylons"] = std::move(pylons);
  summary["jumpers"] = std::move(jumpers);
  summary["insulators"] = std::move(insulators);
  if (!options.hazards.empty())
    summary["hazards"] = hazardSummary(cloud, options.hazards);
  // File names may not be UTF-8, but JSON must be.
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace linelet::powerline
