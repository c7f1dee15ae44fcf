// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline_output/power_line_report.h>

#include <string>

#include "render_template.h"
#include "report_page.h"
#include "report_sections.h"

namespace linelet::powerline {

namespace {

using Json = nlohmann::ordered_json;

std::string
unitsInWords(const io::Units& units)
{
  std::string words = "lengths and heights in meters";
  if (!units.areMeters())
    words +=
        ", coordinates x and y in " + units.plan_name + ", z in " + units.height_name;
  return words;
}

std::string
inWords(const Provenance& from)
{
  return from.program + (from.program.empty() || from.date.empty() ? "" : " · ") +
         from.date;
}

} // namespace

std::string
powerLineReport(const io::Cloud& cloud,
                const PowerLineNetwork& network,
                const OutputOptions& options,
                const ProgressMonitor* monitor)
{
  const report::Content content{cloud,
                                network,
                                options,
                                MetricFrame(cloud),
                                io::UsablePoints(cloud, nullptr, options.points)};
  const std::string reference = io::referenceName(cloud.wkt);
  Json sections = Json::array();
  for (const report::Section& section : report::sectionsOf(content, monitor))
    sections.push_back(
        {{"id", section.id},
         {"title", section.title},
         {"body", report::renderTemplate(section.id + ".mustache", section.data)}});
  throwIfCanceled(monitor);
  return report::renderTemplate(
      "page.mustache",
      {{"source", options.source.empty() ? "point cloud" : options.source},
       {"points", options.input ? options.input->points : cloud.points.size()},
       {"reference", reference.empty() ? "reference system unknown" : reference},
       {"units", unitsInWords(content.metric.units())},
       {"provenance", inWords(options.provenance)},
       {"sections", std::move(sections)}});
}

} // namespace linelet::powerline
