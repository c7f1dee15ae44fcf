// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/state_change.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief A conductor from dead end to dead end, before and after the change of state.
 */
struct StrainSection {
  int circuit = 0;
  std::vector<int> wires;              ///< ids, in order
  double ruling_span = 0;              ///< meters
  double tension = 0, new_tension = 0; ///< horizontal, newtons
};

/** \brief The wires of a network in another state. */
struct StateOfWires {
  std::vector<Wire> wires; ///< those of the network, with clearances unknown
  std::vector<StrainSection> sections;
};

/** \brief How wires are brought to another state. */
struct StateSettings {
  Conductor conductor;
  /// Temperature of the conductor during the scan, degrees Celsius
  double measured_temperature = 15;
  /// A support where the line turns by more than this is a dead end; degrees
  double dead_end_angle = 10;
  std::vector<int> dead_ends; ///< ids of supports that are dead ends in any case
};

/** \brief Brings every wire of \a network to \a state, section by section.
 *
 * A section is a chain of wires from attachment to attachment. It ends where the line
 * ends or turns by more than \ref StateSettings::dead_end_angle, at the named supports,
 * and where the catenary constants on both sides differ by more than four times what
 * the scatter of their points explains: suspension insulators would equalize the
 * tensions. Attachments stay in place; every wire keeps its own ratio to the section's
 * mean, so that the state as scanned leaves all curves unchanged.
 * \param[in] side 1 or -1: wind blows to the right or to the left of the wires
 * \throws std::invalid_argument */
StateOfWires
moveToState(const PowerLineNetwork& network,
            const StateSettings& settings,
            const ConductorState& state,
            double side = 1);

} // namespace powerline
} // namespace linelet
