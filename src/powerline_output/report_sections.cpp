// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_sections.h"

#include <utility>

#include "report_table.h"

namespace linelet::powerline::report {

namespace {

using Json = nlohmann::ordered_json;

std::string
counted(std::size_t count, const std::string& one)
{
  return std::to_string(count) + " " + (count == 1 ? one : one + "s");
}

Json
totalsOf(const Content& content)
{
  const PowerLineNetwork& network = content.network;
  double length = 0;
  std::size_t below = 0, doubtful = 0, poles = 0;
  for (const Wire& wire : network.wires) {
    length += wire.length;
    below += belowClearance(wire, content.options.clearance) ? 1 : 0;
    doubtful += wire.reason.empty() ? 0 : 1;
  }
  for (const Support& support : network.supports)
    poles += support.kind == Support::Kind::Pole ? 1 : 0;
  Json totals = Json::array();
  const auto add = [&](const std::string& value, const std::string& what, bool alarm) {
    totals.push_back({{"value", value}, {"what", what}, {"alarm", alarm}});
  };
  const auto addCount = [&](std::size_t count, const std::string& one) {
    add(std::to_string(count), count == 1 ? one : one + "s", false);
  };
  addCount(network.circuits.size(), "line");
  addCount(network.spans.size(), "span");
  addCount(network.wires.size(), "wire");
  add(number(length / 1000, 3) + " km", "of wire", false);
  addCount(network.supports.size() - poles, "pylon");
  addCount(poles, "pole");
  add(std::to_string(below),
      "wires below " + number(content.options.clearance, 1) + " m clearance",
      below > 0);
  add(std::to_string(doubtful), "wires in doubt", false);
  return totals;
}

} // namespace

Section
summarySection(const Content& content)
{
  return {"summary",
          "",
          {{"totals", totalsOf(content)}, {"no_wires", content.network.wires.empty()}}};
}

Section
planSection(const Content& content)
{
  Markup drawing;
  addPlan(drawing, content);
  return {"plan", "Plan", {{"drawing", drawing.text()}}};
}

Section
spansSection(const Content& content)
{
  return {"spans", "Spans", spanTable(content)};
}

Section
profilesSection(const Content& content, const ProgressMonitor* monitor)
{
  const std::vector<Indices> points = pointsOfSpans(content);
  Json spans = Json::array();
  for (std::size_t k = 0; k < content.network.spans.size(); ++k) {
    throwIfCanceled(monitor);
    const Span& span = content.network.spans[k];
    Markup profile;
    addProfile(profile, content, span, points[k]);
    spans.push_back({{"id", span.id},
                     {"from", content.supportName(span.from_support)},
                     {"to", content.supportName(span.to_support)},
                     {"line", span.circuit},
                     {"number", span.number},
                     {"length", number(span.length, 1)},
                     {"azimuth", number(span.azimuth, 1)},
                     {"wires", counted(span.wires.size(), "wire")},
                     {"profile", profile.text()},
                     {"table", wireTable(content, span)}});
  }
  return {"profiles", "Profiles", {{"spans", std::move(spans)}}};
}

Section
settingsSection(const Content& content)
{
  const Provenance& from = content.options.provenance;
  Table table({{"setting", true}, {"value", true}}, "narrow");
  for (const auto& [name, value] : from.settings)
    table.row({{name}, {value}});
  return {"settings",
          "Settings",
          {{"inputs", from.inputs},
           {"table", from.settings.empty() ? Json() : table.json()}}};
}

std::vector<Section>
sectionsOf(const Content& content, const ProgressMonitor* monitor)
{
  std::vector<Section> sections = {summarySection(content)};
  throwIfCanceled(monitor);
  sections.push_back(planSection(content));
  throwIfCanceled(monitor);
  if (!content.network.wires.empty()) {
    sections.push_back(clearancesSection(content));
    sections.push_back(spansSection(content));
    sections.push_back(profilesSection(content, monitor));
  }
  const Provenance& from = content.options.provenance;
  if (!from.inputs.empty() || !from.settings.empty())
    sections.push_back(settingsSection(content));
  return sections;
}

} // namespace linelet::powerline::report
