// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_marks.h"

#include <algorithm>

namespace linelet::powerline::report {

std::vector<LowWire>
lowWires(const Content& content)
{
  const double limit = content.options.clearance;
  std::vector<LowWire> hazards;
  for (const Wire& wire : content.network.wires) {
    if (wire.ground.distance < limit)
      hazards.push_back({&wire, &wire.ground, "ground"});
    if (wire.vegetation.distance < limit)
      hazards.push_back({&wire, &wire.vegetation, "object (tree, bush, building)"});
  }
  std::stable_sort(
      hazards.begin(), hazards.end(), [](const LowWire& a, const LowWire& b) {
        return a.found->distance < b.found->distance;
      });
  return hazards;
}

std::vector<SpaceMark>
spaceMarks(const Content& content)
{
  std::vector<SpaceMark> marks;
  const auto add = [&](const Clearance& found,
                       const std::string& key,
                       const std::string& what,
                       double meters) {
    marks.push_back(
        {found.wire, found.other, key, content.length(meters, 2) + " m " + what});
  };
  if (content.options.hazards.empty()) {
    for (const LowWire& low : lowWires(content))
      add(*low.found,
          std::to_string(marks.size() + 1),
          std::string("to ") + low.what + ", span " + std::to_string(low.wire->span) +
              ", wire " + std::to_string(low.wire->number),
          low.found->distance);
    return marks;
  }
  const Hazards& hazards = content.options.hazards.front();
  for (const Encroachment& one : hazards.clearances)
    add(one.nearest,
        "c" + std::to_string(one.id),
        "to " + std::string(nameOf(one.kind)) + ", span " + std::to_string(one.span) +
            ", wire " + std::to_string(content.wire(one.wire).number),
        one.nearest.distance);
  for (const Crossing& one : hazards.crossings)
    add(one.nearest,
        "x" + std::to_string(one.id),
        "between crossing wires",
        one.nearest.distance);
  for (const FallIn& one : hazards.fall_in)
    marks.push_back({one.at,
                     one.top,
                     "t" + std::to_string(one.id),
                     "a tree of " + content.length(one.height, 1) + " m, span " +
                         std::to_string(one.span)});
  return marks;
}

} // namespace linelet::powerline::report
