// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_hazards.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <linelet/powerline_output/below_clearance.h>

#include "report_marks.h"
#include "report_table.h"

namespace linelet::powerline::report {

namespace {

using Json = nlohmann::ordered_json;

std::string
spanLink(int span)
{
  return span > 0 ? "#span" + std::to_string(span) : "";
}

Table::Cell
distance(const Content& content,
         double value,
         Severity severity,
         const std::string& key)
{
  return {content.length(value, 2),
          severity == Severity::High,
          key.empty() ? key : spaceLink(key)};
}

/** Key of a hazard in the 3D view, which shows the wires as scanned; empty for other
 * states. */
std::string
keyOf(const Content& content, const Hazards& hazards, const char* kind, int id)
{
  return &hazards == &content.options.hazards.front() ? kind + std::to_string(id)
                                                      : std::string();
}

/** By severity, then by distance. */
std::vector<const Encroachment*>
inOrder(const Hazards& hazards)
{
  std::vector<const Encroachment*> all;
  for (const Encroachment& one : hazards.clearances)
    all.push_back(&one);
  std::stable_sort(
      all.begin(), all.end(), [](const Encroachment* a, const Encroachment* b) {
        return a->severity != b->severity ? a->severity > b->severity
                                          : a->nearest.distance < b->nearest.distance;
      });
  return all;
}

Json
clearanceTable(const Content& content, const Hazards& hazards)
{
  // Plan and profiles show what was scanned.
  const bool shown = hazards.moved.wires.empty();
  if (hazards.clearances.empty())
    return {};
  Table table({{"id"},
               {"severity", true},
               {"to", true},
               {"distance m"},
               {"vertical m"},
               {"horizontal m"},
               {"span"},
               {"wire"},
               {"length m"},
               {"area m²"},
               {"to cut m³"},
               {"x of the wire"},
               {"y"},
               {"z"}});
  for (const Encroachment* one : inOrder(hazards)) {
    const Wire& wire = content.wire(one->wire);
    const Point at = content.metric.world(one->nearest.wire);
    const bool cut = one->kind == HazardKind::Vegetation;
    std::string what(nameOf(one->kind));
    if (one->other > 0)
      what +=
          (one->kind == HazardKind::Support ? " P" : " ") + std::to_string(one->other);
    table.row({{std::to_string(one->id),
                false,
                shown ? "#plan" + std::to_string(one->id) : ""},
               {std::string(nameOf(one->severity)), one->severity == Severity::High},
               {what},
               distance(content,
                        one->nearest.distance,
                        one->severity,
                        keyOf(content, hazards, "c", one->id)),
               {content.length(one->vertical, 2)},
               {content.length(one->horizontal, 2)},
               {std::to_string(one->span), false, spanLink(one->span)},
               {std::to_string(wire.number)},
               {content.length(one->length, 1)},
               {cut ? number(one->area, 1) : ""},
               {cut ? number(one->volume, 1) : ""},
               {number(at.x(), 2)},
               {number(at.y(), 2)},
               {number(at.z(), 2)}},
              "hazard" + std::to_string(one->id));
  }
  return table.json();
}

Json
crossingTable(const Content& content, const Hazards& hazards)
{
  if (hazards.crossings.empty())
    return {};
  Table table({{"id"},
               {"severity", true},
               {"upper span"},
               {"wire"},
               {"lower span"},
               {"wire"},
               {"vertical gap m"},
               {"closest m"},
               {"horizontal m"},
               {"angle °"},
               {"x"},
               {"y"}});
  for (const Crossing& one : hazards.crossings) {
    const Wire &upper = content.wire(one.upper), &lower = content.wire(one.lower);
    const Point at = content.metric.world(one.upper_at);
    table.row({{std::to_string(one.id)},
               {std::string(nameOf(one.severity)), one.severity == Severity::High},
               {std::to_string(upper.span), false, spanLink(upper.span)},
               {std::to_string(upper.number)},
               {std::to_string(lower.span), false, spanLink(lower.span)},
               {std::to_string(lower.number)},
               {content.length(one.vertical, 2)},
               distance(content,
                        one.nearest.distance,
                        one.severity,
                        keyOf(content, hazards, "x", one.id)),
               {content.length(one.horizontal, 2)},
               {number(one.angle, 0)},
               {number(at.x(), 2)},
               {number(at.y(), 2)}},
              "crossing" + std::to_string(one.id));
  }
  return table.json();
}

Json
fallInTable(const Content& content, const Hazards& hazards)
{
  if (hazards.fall_in.empty())
    return {};
  Table table({{"id"},
               {"severity", true},
               {"gap m"},
               {"height m"},
               {"foot to wire m"},
               {"span"},
               {"wire"},
               {"x of the top"},
               {"y"},
               {"z"}});
  for (const FallIn& one : hazards.fall_in) {
    const Point at = content.metric.world(one.top);
    table.row(
        {{std::to_string(one.id), false, "#plantree" + std::to_string(one.id)},
         {std::string(nameOf(one.severity)), one.severity == Severity::High},
         distance(content, one.gap, one.severity, keyOf(content, hazards, "t", one.id)),
         {content.length(one.height, 1)},
         {content.length(one.distance, 1)},
         {std::to_string(one.span), false, spanLink(one.span)},
         {std::to_string(content.wire(one.wire).number)},
         {number(at.x(), 2)},
         {number(at.y(), 2)},
         {number(at.z(), 2)}},
        "tree" + std::to_string(one.id));
  }
  return table.json();
}

Json
limitsTable(const Content& content, const ClearanceLimits& limits)
{
  Table table({{"to", true}, {"high below m"}, {"medium m"}, {"low m"}}, "narrow");
  for (const auto& [kind, name] : Names<HazardKind>::table) {
    const ClearanceLimits::Row& row = limits.of(kind);
    table.row({{kind == HazardKind::FallIn ? "fallen tree" : std::string(name)},
               {content.length(row.high, 2)},
               {content.length(row.medium, 2)},
               {content.length(row.low, 2)}});
  }
  return table.json();
}

Json
statesTable(const Content& content)
{
  if (content.options.hazards.size() < 2)
    return {};
  Table table({{"state", true},
               {"largest sag m"},
               {"lowest above ground m"},
               {"span"},
               {"high"},
               {"medium"},
               {"low"},
               {"trees"}});
  for (const Hazards& at : content.options.hazards) {
    const auto& wires = at.moved.wires.empty() ? content.network.wires : at.moved.wires;
    const Wire* lowest = nullptr;
    double sag = 0;
    for (const Wire& wire : wires) {
      sag = std::max(sag, wire.sag);
      if (wire.ground.known() &&
          (lowest == nullptr || wire.ground.distance < lowest->ground.distance))
        lowest = &wire;
    }
    std::size_t counts[4] = {};
    for (const Encroachment& one : at.clearances)
      ++counts[static_cast<std::size_t>(one.severity)];
    const double least = lowest != nullptr ? lowest->ground.distance : NAN;
    table.row({{at.state},
               {content.length(sag, 2)},
               {content.length(least, 2),
                at.limits.severity(HazardKind::Ground, least) == Severity::High},
               {lowest != nullptr ? std::to_string(lowest->span) : "",
                false,
                lowest != nullptr ? spanLink(lowest->span) : ""},
               {std::to_string(counts[3]), counts[3] > 0},
               {std::to_string(counts[2])},
               {std::to_string(counts[1])},
               {std::to_string(at.fall_in.size())}});
  }
  return table.json();
}

Json
sectionsTable(const Content& content, const Hazards& at)
{
  if (at.moved.sections.empty())
    return {};
  Table table({{"circuit"},
               {"strain section (span.wire)", true},
               {"ruling span m"},
               {"tension kN"},
               {"new tension kN"}},
              "narrow");
  for (const StrainSection& section : at.moved.sections) {
    std::string spans;
    for (const int id : section.wires)
      spans += (spans.empty() ? "" : ", ") + std::to_string(content.wire(id).span) +
               "." + std::to_string(content.wire(id).number);
    table.row({{std::to_string(section.circuit)},
               {spans},
               {number(section.ruling_span, 1)},
               {number(section.tension / 1000, 2)},
               {number(section.new_tension / 1000, 2)}});
  }
  return table.json();
}

} // namespace

Section
hazardsSection(const Content& content)
{
  const Hazards& scanned = content.options.hazards.front();
  Json data = {{"limits", scanned.limits.name},
               {"limits_table", {{"table", limitsTable(content, scanned.limits)}}},
               {"unexplained",
                muchIsUnexplained(content.network)
                    ? Json(number(unexplainedLength(content.network), 0))
                    : Json()},
               {"unknown", clearancesAreUnknown(content.network)},
               {"no_clearances", scanned.clearances.empty()}};
  const auto add = [&](const char* key, Json table) {
    data[key] = table.is_null() ? Json() : Json{{"table", std::move(table)}};
  };
  add("clearances", clearanceTable(content, scanned));
  add("crossings", crossingTable(content, scanned));
  add("fall_in", fallInTable(content, scanned));
  return {"hazards", "Hazards", std::move(data)};
}

Section
statesSection(const Content& content)
{
  Json states = Json::array();
  for (const Hazards& at : content.options.hazards) {
    if (at.moved.wires.empty())
      continue;
    const Json clearances = clearanceTable(content, at),
               sections = sectionsTable(content, at);
    states.push_back(
        {{"state", at.state},
         {"clearances", clearances.is_null() ? Json() : Json{{"table", clearances}}},
         {"sections", sections.is_null() ? Json() : Json{{"table", sections}}}});
  }
  return {"states",
          "Other states of the conductors",
          {{"overview", {{"table", statesTable(content)}}},
           {"unknown", clearancesAreUnknown(content.network)},
           {"states", std::move(states)}}};
}

} // namespace linelet::powerline::report
