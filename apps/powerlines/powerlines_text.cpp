// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerlines_text.h"

#include <cstdio>
#include <optional>
#include <utility>

#include <linelet/powerline_output/output_files.h>

namespace linelet::apps {

namespace {

using powerline::Clearance;
using powerline::PowerLineNetwork;
using powerline::Wire;

/** The smallest known clearance of one kind, and its wire. */
std::pair<Clearance, int>
lowest(const PowerLineNetwork& network, Clearance Wire::*kind)
{
  std::pair<Clearance, int> result{{}, 0};
  for (const Wire& wire : network.wires) {
    const Clearance& c = wire.*kind;
    if (c.known() && !(c.distance >= result.first.distance))
      result = {c, wire.id};
  }
  return result;
}

void
printClearance(const char* name, const PowerLineNetwork& network, Clearance Wire::*kind)
{
  const auto [clearance, wire] = lowest(network, kind);
  if (clearance.known())
    std::printf("%-22s %.2f m (wire %d)\n", name, clearance.distance, wire);
}

nlohmann::ordered_json
toJson(const PowerLineNetwork& network, Clearance Wire::*kind)
{
  const auto [clearance, wire] = lowest(network, kind);
  if (!clearance.known())
    return nullptr;
  return {{"distance", clearance.distance}, {"wire", wire}};
}

/** \brief Totals over the wires of a network. */
struct Totals {
  double length = 0;                ///< meters
  std::optional<std::size_t> below; ///< wires below the limit; nothing: unknown
  std::size_t doubtful = 0;         ///< wires with a reason to doubt them
};

Totals
totalsOf(const PowerLineNetwork& network, double clearance)
{
  Totals totals;
  totals.below = powerline::wiresBelowClearance(network, clearance);
  for (const Wire& wire : network.wires) {
    totals.length += wire.length;
    totals.doubtful += wire.reason.empty() ? 0 : 1;
  }
  return totals;
}

void
print(const PowerLineNetwork& network, const Totals& totals, double clearance)
{
  std::printf("%-22s %zu\n", "circuits", network.circuits.size());
  std::printf("%-22s %zu\n", "spans", network.spans.size());
  std::printf("%-22s %zu (%.0f m, %zu of low confidence)\n",
              "wires",
              network.wires.size(),
              totals.length,
              totals.doubtful);
  std::printf("%-22s %zu\n", "pylons and poles", network.supports.size());
  if (!network.jumpers.empty() || !network.insulators.empty())
    std::printf("%-22s %zu, %zu\n",
                "jumpers, insulators",
                network.jumpers.size(),
                network.insulators.size());
  std::printf("%-22s %zu (%.0f m)\n",
              "unexplained lines",
              network.unexplained.size(),
              unexplainedLength(network));
  printClearance("lowest above ground", network, &Wire::ground);
  printClearance("nearest to vegetation", network, &Wire::vegetation);
  if (totals.below)
    std::printf(
        "%-22s %zu wires below %.1f m\n", "clearance", *totals.below, clearance);
  else
    std::printf("%-22s unknown: neither ground nor objects were seen near the wires\n",
                "clearance");
}

void
print(const powerline::Hazards& hazards)
{
  std::size_t high = 0;
  for (const powerline::Encroachment& one : hazards.clearances)
    high += one.severity == powerline::Severity::High ? 1 : 0;
  std::printf("%-22s %zu hazards (%zu severe), %zu trees that could fall in, %zu "
              "crossings\n",
              hazards.state.c_str(),
              hazards.clearances.size(),
              high,
              hazards.fall_in.size(),
              hazards.crossings.size());
}

void
summarize(nlohmann::ordered_json& summary,
          const PowerLineNetwork& network,
          const Totals& totals)
{
  summary["circuits"] = network.circuits.size();
  summary["spans"] = network.spans.size();
  summary["wires"] = network.wires.size();
  summary["length"] = totals.length;
  summary["supports"] = network.supports.size();
  summary["jumpers"] = network.jumpers.size();
  summary["insulators"] = network.insulators.size();
  summary["unexplained_lines"] = network.unexplained.size();
  summary["unexplained_length"] = unexplainedLength(network);
  summary["ground_clearance"] = toJson(network, &Wire::ground);
  summary["vegetation_clearance"] = toJson(network, &Wire::vegetation);
  summary["wires_below_clearance"] = nullptr;
  if (totals.below)
    summary["wires_below_clearance"] = *totals.below;
  for (const powerline::StageTime& stage : network.stages)
    summary["stage_seconds"][stage.stage] = stage.seconds;
}

} // namespace

void
printPowerLines(const PowerLineNetwork& network,
                const std::vector<powerline::Hazards>& hazards,
                double points,
                double clearance)
{
  if (network.wires.empty()) {
    std::printf("no wires found in %.0f points\n", points);
    return;
  }
  print(network, totalsOf(network, clearance), clearance);
  for (const powerline::Hazards& state : hazards)
    print(state);
}

void
summarizePowerLines(nlohmann::ordered_json& summary,
                    const PowerLineNetwork& network,
                    const std::vector<powerline::Hazards>& hazards,
                    double clearance)
{
  summarize(summary, network, totalsOf(network, clearance));
  for (const powerline::Hazards& state : hazards)
    summary["hazards"].push_back({{"state", state.state},
                                  {"clearances", state.clearances.size()},
                                  {"crossings", state.crossings.size()},
                                  {"fall_in", state.fall_in.size()}});
}

} // namespace linelet::apps
