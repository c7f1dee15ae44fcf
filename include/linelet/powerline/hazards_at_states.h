// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/powerline/find_surroundings.h>
#include <linelet/powerline/hazards.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief Which hazards to look for, and in which states of the conductors. */
struct HazardSettings {
  std::string limits;    ///< see \ref readLimits; empty: PowerLineSettings::clearance
  std::string conductor; ///< see \ref readConductor; empty: no other state
  double conductor_temperature = 15; ///< during the scan, degrees Celsius
  std::vector<std::string> states;   ///< see \ref parseState
  std::vector<double> dead_ends;     ///< ids of supports that are dead ends
  double dead_end_angle = 10;        ///< see \ref StateSettings, degrees
  SurroundingClasses classes;
};

template <class Visit>
void
describe(HazardSettings& s, Visit&& visit)
{
  visit("limits",
        s.limits,
        "Hazards: clearances and their severities: a file of lines 'KIND HIGH MEDIUM "
        "LOW' in meters (ground, vegetation, building, wire, support, fall_in), or "
        "en50341:KV or nesc:KV as starting values; default: --clearance for all kinds");
  visit("conductor",
        s.conductor,
        "Hazards: type of all conductors (Drake, 240/40, ...) or a file of lines 'KEY "
        "VALUE': area (mm2), diameter (mm), mass (kg/km), modulus (GPa), expansion "
        "(1e-6/K), creep (K)");
  visit("conductor-temperature",
        s.conductor_temperature,
        "Hazards: temperature of the conductors during the scan, degrees Celsius");
  visit("state",
        s.states,
        "Hazards: also look for hazards in this state of the conductors: 75C, or "
        "0C,ice=10mm,wind=400Pa; may be repeated");
  visit("dead-ends",
        s.dead_ends,
        "Hazards: ids of supports (pylon_id) that are dead ends");
  visit("dead-end-angle",
        s.dead_end_angle,
        "Hazards: a support is also a dead end where the line turns by more than this, "
        "degrees");
  describe(s.classes, visit);
}

/** \brief The hazards of a network as scanned, then in every requested state, with wind
 * from both sides. Ids continue from state to state.
 * \param[in] clearance limit if the settings name none, meters
 * \throws std::invalid_argument, io::FileError, Canceled */
std::vector<Hazards>
findHazardsAtStates(const PowerLineNetwork& network,
                    const io::Cloud& cloud,
                    const io::UsablePoints& usable,
                    const HazardSettings& settings,
                    double clearance,
                    unsigned threads = 0,
                    const ProgressMonitor* monitor = nullptr);

/** \brief The same, if the surroundings are known. */
std::vector<Hazards>
findHazardsAtStates(const PowerLineNetwork& network,
                    const Surroundings& surroundings,
                    const HazardSettings& settings,
                    double clearance,
                    unsigned threads = 0,
                    const ProgressMonitor* monitor = nullptr);

/** \brief The limits of \a settings. \param[in] clearance as above
 * \throws std::invalid_argument, io::FileError */
ClearanceLimits
limitsOf(const HazardSettings& settings, double clearance);

/** \brief Throws what \ref findHazardsAtStates would throw for its settings, before
 * long work. */
void
check(const HazardSettings& settings);

} // namespace powerline
} // namespace linelet
