// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline/hazards_at_states.h>

#include <linelet/powerline/find_hazards.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "powerline/network/clearances.h"

namespace linelet::powerline {

namespace {

/** A network without its per-point lists. */
PowerLineNetwork
withoutPoints(const PowerLineNetwork& network)
{
  PowerLineNetwork copy;
  copy.wires = network.wires;
  copy.spans = network.spans;
  copy.supports = network.supports;
  copy.circuits = network.circuits;
  copy.ground = network.ground;
  return copy;
}

void
numberOn(std::vector<Hazards>& states)
{
  int hazards = 0, crossings = 0, trees = 0;
  for (Hazards& at : states) {
    for (Encroachment& one : at.clearances)
      one.id = ++hazards;
    for (Crossing& one : at.crossings)
      one.id = ++crossings;
    for (FallIn& one : at.fall_in)
      one.id = ++trees;
  }
}

StateSettings
stateSettings(const HazardSettings& settings)
{
  StateSettings out;
  out.conductor = readConductor(settings.conductor);
  out.measured_temperature = settings.conductor_temperature;
  out.dead_end_angle = settings.dead_end_angle;
  for (const double id : settings.dead_ends)
    out.dead_ends.push_back(static_cast<int>(id));
  return out;
}

} // namespace

void
check(const HazardSettings& settings)
{
  if (!settings.limits.empty())
    readLimits(settings.limits, uniformLimits(1));
  if (!settings.conductor.empty())
    readConductor(settings.conductor);
  for (const std::string& state : settings.states)
    parseState(state);
  if (!settings.states.empty() && settings.conductor.empty())
    throw std::invalid_argument("--state needs the type of the conductors; "
                                "name it, or a file, with --conductor");
  if (settings.states.empty() && !settings.conductor.empty())
    throw std::invalid_argument("--conductor has no effect without --state; "
                                "add --state 75C, for example");
  if (!std::isfinite(settings.conductor_temperature) ||
      std::abs(settings.conductor_temperature) > 300)
    throw std::invalid_argument("conductor-temperature must be one from -300 to 300 "
                                "degrees Celsius");
  if (!(settings.dead_end_angle > 0 && settings.dead_end_angle <= 180))
    throw std::invalid_argument("dead-end-angle must be above 0, up to 180 degrees");
}

ClearanceLimits
limitsOf(const HazardSettings& settings, double clearance)
{
  const ClearanceLimits limits = uniformLimits(clearance);
  return settings.limits.empty() ? limits : readLimits(settings.limits, limits);
}

std::vector<Hazards>
findHazardsAtStates(const PowerLineNetwork& network,
                    const io::Cloud& cloud,
                    const io::UsablePoints& usable,
                    const HazardSettings& settings,
                    double clearance,
                    unsigned threads,
                    const ProgressMonitor* monitor)
{
  check(settings);
  const Surroundings surroundings = findSurroundings(network,
                                                     cloud,
                                                     usable,
                                                     limitsOf(settings, clearance),
                                                     settings.classes,
                                                     threads,
                                                     monitor);
  return findHazardsAtStates(
      network, surroundings, settings, clearance, threads, monitor);
}

std::vector<Hazards>
findHazardsAtStates(const PowerLineNetwork& network,
                    const Surroundings& surroundings,
                    const HazardSettings& settings,
                    double clearance,
                    unsigned threads,
                    const ProgressMonitor* monitor)
{
  check(settings);
  const ClearanceLimits limits = limitsOf(settings, clearance);
  std::vector<Hazards> states = {
      findHazards(network, surroundings, limits, threads, monitor)};
  if (!settings.states.empty()) {
    PowerLineNetwork moved = withoutPoints(network);
    const StateSettings how = stateSettings(settings);
    for (const std::string& text : settings.states) {
      const ConductorState state = parseState(text);
      for (const double side : {1.0, -1.0}) {
        if (side < 0 && state.wind == 0)
          continue;
        StateOfWires there = moveToState(network, how, state, side);
        for (Wire& wire : there.wires)
          wire.ground = lowestAboveGround(wire.curve, network.ground);
        moved.wires = there.wires;
        states.push_back(findHazards(moved, surroundings, limits, threads, monitor));
        states.back().state = state.wind == 0 ? state.name
                              : side > 0      ? state.name + " to the right"
                                              : state.name + " to the left";
        states.back().moved = std::move(there);
      }
    }
  }
  numberOn(states);
  return states;
}

} // namespace linelet::powerline
