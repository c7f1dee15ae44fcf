// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/state_change.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief A conductor from dead end to dead end, and what becomes of it. */
struct StrainSection {
  int circuit = 0;
  std::vector<int> wires;              ///< ids, in order
  double ruling_span = 0;              ///< meters
  double tension = 0, new_tension = 0; ///< horizontal, newton
};

/** \brief The wires of a network in another state. */
struct StateOfWires {
  std::vector<Wire> wires; ///< as many as the network has, with clearances unknown
  std::vector<StrainSection> sections;
};

/** \brief How wires are brought to another state. */
struct StateSettings {
  Conductor conductor;
  double measured_temperature = 15; ///< of the conductor during the scan, Celsius
  double dead_end_angle = 10;       ///< a line that turns by more ends at its support
  std::vector<int> dead_ends;       ///< ids of supports that are dead ends in any case
};

/** \brief Brings every wire of \a network to \a state, section by section.
 *
 * A section is a chain of wires from attachment to attachment. It ends where the line
 * ends, turns by more than \ref StateSettings::dead_end_angle, at the supports that are
 * named, and where the catenary constants on both sides differ by more than four times
 * what the scatter of their points explains: insulators that hang let tensions become
 * equal. Attachments stay where they are; every wire keeps its own ratio to the
 * section's mean, so that no change of state changes no curve.
 * \param[in] side 1 or -1: wind blows to the right or to the left of the wires
 * \throws std::invalid_argument */
StateOfWires
moveToState(const PowerLineNetwork& network,
            const StateSettings& settings,
            const ConductorState& state,
            double side = 1);

} // namespace powerline
} // namespace linelet
