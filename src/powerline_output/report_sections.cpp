// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_sections.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include <linelet/powerline_output/below_clearance.h>
#include <linelet/support/threads.h>

#include "report_plan.h"
#include "report_points.h"
#include "report_profile.h"
#include "report_table.h"
#include "report_tables.h"
#include "support/parallel_failure.h"

namespace linelet::powerline::report {

namespace {

using Json = nlohmann::ordered_json;

std::string
counted(std::size_t count, const std::string& one)
{
  return std::to_string(count) + " " + (count == 1 ? one : one + "s");
}

/** What the page says in its first lines. */
class Totals {
public:
  explicit Totals(const Content& content)
  {
    if (!content.options.hazards.empty())
      addHazards(content);
    addLines(content);
  }

  Json
  data(bool no_wires) const
  {
    return {{"totals", totals_},
            {"no_wires", no_wires},
            {"verdict", verdict_},
            {"verdict_class", verdict_class_}};
  }

private:
  void
  add(const std::string& value, const std::string& what, bool alarm = false)
  {
    totals_.push_back({{"value", value}, {"what", what}, {"alarm", alarm}});
  }

  void
  addCount(std::size_t count, const std::string& one, bool alarm = false)
  {
    add(std::to_string(count), count == 1 ? one : one + "s", alarm);
  }

  void
  addHazards(const Content& content)
  {
    const Hazards& scanned = content.options.hazards.front();
    std::size_t counts[4] = {}, falling = 0;
    double area = 0, volume = 0;
    std::set<int> severe;
    for (const Encroachment& one : scanned.clearances) {
      ++counts[static_cast<std::size_t>(one.severity)];
      if (one.severity == Severity::High)
        severe.insert(one.span);
      area += one.area;
      volume += one.volume;
    }
    for (const FallIn& one : scanned.fall_in)
      falling += one.severity == Severity::High ? 1 : 0;
    addCount(counts[3], "severe hazard", counts[3] > 0);
    addCount(counts[2], "medium hazard");
    addCount(counts[1], "low hazard");
    add(std::to_string(falling),
        falling == 1 ? "tree would hit a wire" : "trees would hit a wire",
        falling > 0);
    if (area > 0)
      add(number(area, 0) + " m²",
          "of vegetation too near, " + number(volume, 0) + " m³");
    std::string spans;
    for (const int span : severe)
      spans += (spans.empty() ? "" : ", ") + std::to_string(span);
    const bool unknown = clearancesAreUnknown(content.network);
    verdict_class_ = counts[3] > 0                                    ? "high"
                     : counts[2] + counts[1] + falling > 0 || unknown ? "medium"
                                                                      : "none";
    verdict_ =
        counts[3] > 0
            ? "Act now: severe hazards in " +
                  std::string(severe.size() == 1 ? "span " : "spans ") + spans + "."
        : counts[2] + counts[1] + falling > 0
            ? "Nothing severe as scanned; see the list for what to plan."
        : unknown ? "Clearances are unknown: neither ground nor objects were seen near "
                    "the wires."
                  : "Nothing is nearer to a wire than its limit, as scanned.";
    if (muchIsUnexplained(content.network))
      verdict_ +=
          " Wires may be missing: " + number(unexplainedLength(content.network), 0) +
          " m look like lines but belong to no wire found.";
    addStates(content);
  }

  void
  addStates(const Content& content)
  {
    for (std::size_t k = 1; k < content.options.hazards.size(); ++k) {
      const Hazards& at = content.options.hazards[k];
      const auto severe = std::count_if(
          at.clearances.begin(), at.clearances.end(), [](const Encroachment& one) {
            return one.severity == Severity::High;
          });
      verdict_ += " At " + at.state + ": " +
                  counted(static_cast<std::size_t>(severe), "severe hazard") + ".";
    }
  }

  void
  addLines(const Content& content)
  {
    const PowerLineNetwork& network = content.network;
    double length = 0;
    std::size_t doubtful = 0, poles = 0;
    for (const Wire& wire : network.wires) {
      length += wire.length;
      doubtful += wire.reason.empty() ? 0 : 1;
    }
    for (const Support& support : network.supports)
      poles += support.kind == Support::Kind::Pole ? 1 : 0;
    addCount(network.circuits.size(), "circuit");
    addCount(network.spans.size(), "span");
    addCount(network.wires.size(), "wire");
    add(number(length / 1000, 3) + " km", "of wire");
    addCount(network.supports.size() - poles, "pylon");
    addCount(poles, "pole");
    addCount(network.jumpers.size(), "jumper");
    addCount(network.insulators.size(), "insulator string");
    if (content.options.hazards.empty()) {
      const auto below = wiresBelowClearance(network, content.options.clearance);
      add(below ? std::to_string(*below) : "unknown",
          "wires below " + number(content.options.clearance, 1) + " m clearance",
          below.value_or(1) > 0);
    }
    add(std::to_string(doubtful), "wires in doubt");
  }

  Json totals_ = Json::array();
  std::string verdict_, verdict_class_;
};

} // namespace

Section
summarySection(const Content& content)
{
  return {"summary", "", Totals(content).data(content.network.wires.empty())};
}

Section
planSection(const Content& content)
{
  Markup drawing;
  addPlan(drawing, content);
  return {"plan",
          "Plan",
          {{"drawing", drawing.text()}, {"hazards", !content.options.hazards.empty()}}};
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
                     {"circuit", span.circuit},
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
  using Maker = std::function<Section()>;
  std::vector<Maker> makers = {[&] { return summarySection(content); },
                               [&] { return planSection(content); }};
  if (!content.network.wires.empty()) {
    makers.emplace_back([&] { return spaceSection(content); });
    const std::size_t states = content.options.hazards.size();
    makers.emplace_back([&content, states] {
      return states > 0 ? hazardsSection(content) : clearancesSection(content);
    });
    if (states > 1)
      makers.emplace_back([&] { return statesSection(content); });
    makers.emplace_back([&] { return spansSection(content); });
    makers.emplace_back([&] { return profilesSection(content, monitor); });
  }
  const Provenance& from = content.options.provenance;
  if (!from.inputs.empty() || !from.settings.empty())
    makers.emplace_back([&] { return settingsSection(content); });
  std::vector<Section> sections(makers.size());
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic)                                             \
    num_threads(threadCount(content.options.threads))
  for (std::size_t k = 0; k < makers.size(); ++k)
    failure.guard([&] {
      throwIfCanceled(monitor);
      sections[k] = makers[k]();
    });
  failure.rethrow();
  return sections;
}

} // namespace linelet::powerline::report
