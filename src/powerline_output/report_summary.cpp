// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_summary.h"

#include <algorithm>
#include <set>

#include <linelet/powerline_output/below_clearance.h>

namespace linelet::powerline::report {

namespace {

using Json = nlohmann::ordered_json;

/** \brief The first lines of the page. */
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
          "of vegetation too close, " + number(volume, 0) + " m³");
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
                  : "Nothing is closer to a wire than its limit, as scanned.";
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
    add(std::to_string(doubtful), "doubtful wires");
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

} // namespace linelet::powerline::report
