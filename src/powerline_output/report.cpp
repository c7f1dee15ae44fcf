// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <string>

#include "report_page.h"

namespace linelet::powerline {

namespace {

using report::Content;
using report::Markup;

constexpr std::string_view style = R"(
:root{color-scheme:light}
*{box-sizing:border-box}
body{margin:0 auto;max-width:1140px;padding:28px 32px 60px;background:#fff;color:#1d232a;
 font:14px/1.45 system-ui,"Segoe UI","Helvetica Neue",Arial,sans-serif}
h1{font-size:26px;margin:0 0 2px}
h2{font-size:18px;margin:34px 0 10px;padding-bottom:4px;border-bottom:2px solid #1d232a}
h3{font-size:15px;margin:0 0 2px}
p{margin:4px 0 10px}
.muted{color:#5d6873}
.totals{display:flex;flex-wrap:wrap;gap:10px;margin:18px 0 4px}
.totals div{flex:1 1 116px;border:1px solid #d5dae0;border-radius:6px;padding:8px 12px}
.totals b{display:block;white-space:nowrap;font-size:22px;font-weight:600;line-height:1.2}
.totals .alarm{border-color:#c8102e;background:#fdf0f2}
.totals .alarm b{color:#c8102e}
svg{display:block;width:100%;height:auto;font:11px system-ui,Arial,sans-serif}
svg a{fill:inherit}
.plan{border:1px solid #d5dae0;border-radius:6px;padding:6px}
.span{margin:22px 0 30px;break-inside:avoid}
table{border-collapse:collapse;width:100%;font-size:12.5px;font-variant-numeric:tabular-nums}
th{text-align:right;font-weight:600;border-bottom:1px solid #1d232a;padding:3px 7px;vertical-align:bottom}
td{text-align:right;white-space:nowrap;border-bottom:1px solid #e4e8ec;padding:3px 7px}
td.text,th.text{text-align:left;white-space:normal}
table.narrow{width:auto}
td i{display:inline-block;width:10px;height:10px;border-radius:2px;margin-right:6px}
em{color:#8a5a00;font-style:normal}
td.bad{color:#c8102e;font-weight:700;background:#fdf0f2}
.wire{fill:none;stroke-width:1.6}
.curve{fill:none;stroke-width:1.3}
.doubtful{stroke-dasharray:7 4}
.support{fill:#1d232a;stroke:#fff;stroke-width:1}
.hazard{fill:none;stroke:#c8102e;stroke-width:2.4}
.badge{fill:#fff;stroke:#1d232a;stroke-width:1}
.name{font-weight:600;font-size:10.5px;text-anchor:middle}
.small{font-size:10.5px;paint-order:stroke;stroke:#fff;stroke-width:3px}
.ink{fill:none;stroke:#1d232a;stroke-width:1.4}
.north{fill:#1d232a}
.grid{fill:none;stroke:#e4e8ec;stroke-width:1}
.tick{fill:#5d6873;paint-order:stroke;stroke:#fff;stroke-width:3px}
.end{text-anchor:end}
.middle{text-anchor:middle}
.ground{fill:#e9e1d2;stroke:#9a8564;stroke-width:1.2}
.dots{fill:none;stroke-width:1.7;stroke-linecap:round}
.other{stroke:#a9b8a4}
.pylon{stroke:#8d97a3}
.onwire{stroke:#c4ccd6}
.clear{fill:none;stroke:#1d232a;stroke-width:1.2;stroke-dasharray:3 3}
.clear.bad{stroke:#c8102e;stroke-width:2;stroke-dasharray:none}
text.bad{fill:#c8102e;font-weight:700}
@page{size:A4;margin:12mm}
@media print{body{max-width:none;padding:0;font-size:11px}table{font-size:9.5px}td,th{padding:2px 4px}
 h2{break-after:avoid}a{color:inherit;text-decoration:none}
 *{print-color-adjust:exact;-webkit-print-color-adjust:exact}}
)";

void
addTotal(Markup& page, const std::string& value, const char* what, bool alarm = false)
{
  page << (alarm ? "<div class=\"alarm\"><b>" : "<div><b>") << value << "</b>" << what
       << "</div>\n";
}

void
addTotals(Markup& page, const Content& content)
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
  const std::string limit =
      "wires below " + report::number(content.options.clearance, 1) + " m clearance";
  page << "<div class=\"totals\">\n";
  const auto addCount = [&](std::size_t count, const std::string& one) {
    addTotal(page, std::to_string(count), (count == 1 ? one : one + "s").c_str());
  };
  addCount(network.circuits.size(), "line");
  addCount(network.spans.size(), "span");
  addCount(network.wires.size(), "wire");
  addTotal(page, report::number(length / 1000, 3) + " km", "of wire");
  addCount(network.supports.size() - poles, "pylon");
  addCount(poles, "pole");
  addTotal(page, std::to_string(below), limit.c_str(), below > 0);
  addTotal(page, std::to_string(doubtful), "wires in doubt");
  page << "</div>\n";
}

void
addSpans(Markup& page, const Content& content, const ProgressMonitor* monitor)
{
  const std::vector<Indices> points = report::pointsOfSpans(content);
  for (std::size_t k = 0; k < content.network.spans.size(); ++k) {
    throwIfCanceled(monitor);
    const Span& span = content.network.spans[k];
    page << "<section class=\"span\" id=\"span" << span.id << "\">\n<h3>Span "
         << span.id << ": " << content.supportName(span.from_support) << " to "
         << content.supportName(span.to_support) << "</h3>\n<p class=\"muted\">line "
         << span.circuit << ", number " << span.number << "; "
         << report::number(span.length, 1) << " m, azimuth "
         << report::number(span.azimuth, 1) << "°, " << span.wires.size()
         << (span.wires.size() == 1 ? " wire" : " wires") << "</p>\n";
    report::addProfile(page, content, span, points[k]);
    report::addWireTable(page, content, span);
    page << "</section>\n";
  }
}

std::string
unitsInWords(const io::Units& units)
{
  std::string words = "lengths and heights in meters";
  if (!units.areMeters())
    words += ", coordinates x and y in " + report::escaped(units.plan_name) +
             ", z in " + report::escaped(units.height_name);
  return words;
}

} // namespace

std::string
powerLineReport(const io::Cloud& cloud,
                const PowerLineNetwork& network,
                const OutputOptions& options,
                const ProgressMonitor* monitor)
{
  const Content content{cloud,
                        network,
                        options,
                        MetricFrame(cloud),
                        io::UsablePoints(cloud, nullptr, options.points)};
  const std::string name = options.source.empty() ? std::string("point cloud")
                                                  : report::escaped(options.source);
  const std::string reference = io::referenceName(cloud.wkt);
  Markup page;
  page << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
          "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\"/>\n"
          "<title>Power lines in "
       << name << "</title>\n<style>" << style
       << "</style>\n</head>\n<body>\n<h1>Power lines</h1>\n<p class=\"muted\">" << name
       << " · " << cloud.points.size() << " points · "
       << (reference.empty() ? "reference system unknown" : report::escaped(reference))
       << " · " << unitsInWords(content.metric.units()) << "</p>\n";
  addTotals(page, content);
  if (network.wires.empty())
    page
        << "<h2>No wires found</h2>\n<p>Nothing in this cloud hangs, spans and is as "
           "thin as a wire. If you know of wires in it, see whether they have points "
           "at all (two a meter and more serve well) and whether they hang higher than "
           "--min-height above the terrain.</p>\n";
  page << "<h2>Plan</h2>\n<p class=\"muted\">The arrow points north. Gray to green: "
          "height of what "
          "stands on the ground. Squares are pylons, dots are poles, red rings "
          "clearances "
          "below the limit.</p>\n";
  throwIfCanceled(monitor);
  report::addPlan(page, content);
  throwIfCanceled(monitor);
  if (!network.wires.empty()) {
    page << "<h2>Clearances below " << report::number(options.clearance, 1)
         << " m</h2>\n";
    report::addHazards(page, content);
    page << "<h2>Spans</h2>\n";
    report::addSpanTable(page, content);
    page
        << "<h2>Profiles</h2>\n<p class=\"muted\">Every span seen from the side, in "
           "its "
           "direction from left to right. Curves are the fitted catenaries (dashed: in "
           "doubt), dots the points beside them.</p>\n";
    addSpans(page, content, monitor);
  }
  page << "</body>\n</html>\n";
  return page.text();
}

} // namespace linelet::powerline
