// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_tables.h"

#include <algorithm>
#include <limits>
#include <string>

#include <linelet/powerline_output/below_clearance.h>

#include "report_marks.h"
#include "report_table.h"

namespace linelet::powerline::report {

namespace {

std::string
percent(double confidence)
{
  return number(100 * confidence, 0) + "\u00a0%";
}

std::string
placeOf(int span)
{
  return "#span" + std::to_string(span);
}

/** The smallest of a clearance over the wires of a span. */
template <class Get>
double
lowest(const Content& content, const Span& span, Get get)
{
  double least = std::numeric_limits<double>::quiet_NaN();
  for (const int id : span.wires) {
    const double distance = get(content.wire(id)).distance;
    if (!(least <= distance)) // true while least is still NaN
      least = distance == distance ? distance : least;
  }
  return least;
}

} // namespace

nlohmann::ordered_json
wireTable(const Content& content, const Span& span)
{
  const double limit = content.options.clearance;
  Table table({{"wire"},
               {"cond."},
               {"length m"},
               {"sag m"},
               {"catenary a m"},
               {"from height m"},
               {"to height m"},
               {"to ground m"},
               {"to objects m"},
               {"points"},
               {"rms m"},
               {"gap m"},
               {"confidence", true}});
  for (const int id : span.wires) {
    const Wire& wire = content.wire(id);
    table.row({{std::to_string(wire.number),
                false,
                "",
                "",
                std::string(wireColor(wire.number))},
               {std::to_string(wire.conductors)},
               {number(wire.length, 2)},
               {number(wire.sag, 2)},
               {number(wire.curve.a, 0)},
               {number(content.metric.metersAbove(wire.front.z()), 2)},
               {number(content.metric.metersAbove(wire.back.z()), 2)},
               {number(wire.ground.distance, 2), wire.ground.distance < limit},
               {number(wire.vegetation.distance, 2), wire.vegetation.distance < limit},
               {std::to_string(wire.points)},
               {number(wire.rms, 3)},
               {number(wire.largest_gap, 1)},
               {percent(wire.confidence), false, "", wire.reason}});
  }
  return table.json();
}

nlohmann::ordered_json
spanTable(const Content& content)
{
  const double limit = content.options.clearance;
  Table table({{"span"},
               {"circuit"},
               {"no."},
               {"supports"},
               {"length m"},
               {"azimuth °"},
               {"wires"},
               {"wire length m"},
               {"largest sag m"},
               {"to ground m"},
               {"to objects m"},
               {"lowest confidence"}});
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
    table.row({{std::to_string(span.id), false, placeOf(span.id)},
               {std::to_string(span.circuit)},
               {std::to_string(span.number)},
               {content.supportName(span.from_support) + " – " +
                content.supportName(span.to_support)},
               {number(span.length, 1)},
               {number(span.azimuth, 1)},
               {std::to_string(span.wires.size())},
               {number(total, 1)},
               {number(sag, 2)},
               {number(ground, 2), ground < limit},
               {number(objects, 2), objects < limit},
               {percent(confidence)}});
  }
  return table.json();
}

Section
clearancesSection(const Content& content)
{
  const double limit = content.options.clearance;
  const std::vector<LowWire> hazards = lowWires(content);
  Table table({{"distance m"},
               {"span"},
               {"wire"},
               {"to", true},
               {"x of the wire"},
               {"y"},
               {"z"}},
              "narrow");
  std::size_t place = 0;
  for (const LowWire& hazard : hazards) {
    const Point at = content.metric.world(hazard.found->wire);
    table.row(
        {{number(hazard.found->distance, 2), true, spaceLink(std::to_string(++place))},
         {std::to_string(hazard.wire->span), false, placeOf(hazard.wire->span)},
         {std::to_string(hazard.wire->number)},
         {hazard.what},
         {number(at.x(), 2)},
         {number(at.y(), 2)},
         {number(at.z(), 2)}});
  }
  return {"clearances",
          "Clearances below " + number(limit, 1) + " m",
          {{"limit", number(limit, 1)},
           {"unexplained",
            muchIsUnexplained(content.network)
                ? nlohmann::ordered_json(number(unexplainedLength(content.network), 0))
                : nlohmann::ordered_json()},
           {"unknown", clearancesAreUnknown(content.network)},
           {"table", hazards.empty() ? nlohmann::ordered_json() : table.json()}}};
}

} // namespace linelet::powerline::report
