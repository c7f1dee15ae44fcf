// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <limits>
#include <string>

#include "report_page.h"

namespace linelet::powerline::report {

namespace {

void
cell(Markup& page, const std::string& text, bool bad = false)
{
  page << (bad ? "<td class=\"bad\">" : "<td>") << text << "</td>";
}

void
head(Markup& page,
     std::initializer_list<const char*> names,
     const char* open = "<table>")
{
  page << open << "\n<thead><tr>";
  for (const std::string name : names)
    // Words stand to the left, figures to the right.
    page << (name == "to" || name == "confidence" ? "<th class=\"text\">" : "<th>")
         << name << "</th>";
  page << "</tr></thead>\n<tbody>\n";
}

std::string
percent(double confidence)
{
  return number(100 * confidence, 0) + "&#160;%";
}

/** Lowest of a clearance over the wires of a span. */
template <class Get>
double
lowest(const Content& content, const Span& span, Get get)
{
  double least = std::numeric_limits<double>::quiet_NaN();
  for (const int id : span.wires) {
    const double distance = get(content.wire(id)).distance;
    if (!(least <= distance)) // also where least is not known yet
      least = distance == distance ? distance : least;
  }
  return least;
}

} // namespace

void
addWireTable(Markup& page, const Content& content, const Span& span)
{
  const double limit = content.options.clearance;
  head(page,
       {"wire",
        "cond.",
        "length m",
        "sag m",
        "catenary a m",
        "from height m",
        "to height m",
        "to ground m",
        "to objects m",
        "points",
        "rms m",
        "gap m",
        "confidence"});
  for (const int id : span.wires) {
    const Wire& wire = content.wire(id);
    page << "<tr><td><i style=\"background:" << wireColor(wire.number) << "\"></i>"
         << wire.number << "</td>";
    cell(page, std::to_string(wire.conductors));
    cell(page, number(wire.length, 2));
    cell(page, number(wire.sag, 2));
    cell(page, number(wire.curve.a, 0));
    cell(page, number(content.metric.metersAbove(wire.front.z()), 2));
    cell(page, number(content.metric.metersAbove(wire.back.z()), 2));
    cell(page, number(wire.ground.distance, 2), wire.ground.distance < limit);
    cell(page, number(wire.vegetation.distance, 2), wire.vegetation.distance < limit);
    cell(page, std::to_string(wire.points));
    cell(page, number(wire.rms, 3));
    cell(page, number(wire.largest_gap, 1));
    page << "<td class=\"text\">" << percent(wire.confidence);
    if (!wire.reason.empty())
      page << " <em>" << escaped(wire.reason) << "</em>";
    page << "</td></tr>\n";
  }
  page << "</tbody>\n</table>\n";
}

void
addSpanTable(Markup& page, const Content& content)
{
  const double limit = content.options.clearance;
  head(page,
       {"span",
        "line",
        "no.",
        "pylons",
        "length m",
        "azimuth °",
        "wires",
        "wire length m",
        "largest sag m",
        "to ground m",
        "to objects m",
        "lowest confidence"});
  for (const Span& span : content.network.spans) {
    double total = 0, sag = 0, confidence = 1;
    for (const int id : span.wires) {
      const Wire& wire = content.wire(id);
      total += wire.length;
      sag = std::max(sag, wire.sag);
      confidence = std::min(confidence, wire.confidence);
    }
    const double ground =
        lowest(content, span, [](const Wire& wire) { return wire.ground; });
    const double objects =
        lowest(content, span, [](const Wire& wire) { return wire.vegetation; });
    page << "<tr><td><a href=\"#span" << span.id << "\">" << span.id << "</a></td>";
    cell(page, std::to_string(span.circuit));
    cell(page, std::to_string(span.number));
    cell(page,
         content.supportName(span.from_support) + " – " +
             content.supportName(span.to_support));
    cell(page, number(span.length, 1));
    cell(page, number(span.azimuth, 1));
    cell(page, std::to_string(span.wires.size()));
    cell(page, number(total, 1));
    cell(page, number(sag, 2));
    cell(page, number(ground, 2), ground < limit);
    cell(page, number(objects, 2), objects < limit);
    cell(page, percent(confidence));
    page << "</tr>\n";
  }
  page << "</tbody>\n</table>\n";
}

void
addHazards(Markup& page, const Content& content)
{
  struct Hazard {
    const Wire* wire;
    const Clearance* found;
    const char* what;
  };
  std::vector<Hazard> hazards;
  for (const Wire& wire : content.network.wires) {
    if (wire.ground.distance < content.options.clearance)
      hazards.push_back({&wire, &wire.ground, "ground"});
    if (wire.vegetation.distance < content.options.clearance)
      hazards.push_back({&wire, &wire.vegetation, "object (tree, bush, building)"});
  }
  std::stable_sort(
      hazards.begin(), hazards.end(), [](const Hazard& a, const Hazard& b) {
        return a.found->distance < b.found->distance;
      });
  const std::string limit = number(content.options.clearance, 1);
  if (hazards.empty()) {
    page << "<p>No wire comes closer than " << limit
         << " m to the ground or to an object.</p>\n";
    return;
  }
  head(page,
       {"distance m", "span", "wire", "to", "x of the wire", "y", "z"},
       "<table class=\"narrow\">");
  for (const Hazard& hazard : hazards) {
    const Point at = content.metric.world(hazard.found->wire);
    page << "<tr>";
    cell(page, number(hazard.found->distance, 2), true);
    page << "<td><a href=\"#span" << hazard.wire->span << "\">" << hazard.wire->span
         << "</a></td>";
    cell(page, std::to_string(hazard.wire->number));
    page << "<td class=\"text\">" << hazard.what << "</td>";
    cell(page, number(at.x(), 2));
    cell(page, number(at.y(), 2));
    cell(page, number(at.z(), 2));
    page << "</tr>\n";
  }
  page << "</tbody>\n</table>\n";
}

} // namespace linelet::powerline::report
