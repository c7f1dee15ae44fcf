// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_sections.h"

#include <functional>
#include <utility>

#include <linelet/support/threads.h>

#include "report_hazards.h"
#include "report_plan.h"
#include "report_points.h"
#include "report_profile.h"
#include "report_space.h"
#include "report_summary.h"
#include "report_table.h"
#include "report_tables.h"
#include "support/parallel_failure.h"

namespace linelet::powerline::report {

namespace {

using Json = nlohmann::ordered_json;

/** \brief The lines seen from above. */
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

/** \brief Profile and wires of every span. */
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

/** \brief Inputs and settings of the run. */
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

} // namespace

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
