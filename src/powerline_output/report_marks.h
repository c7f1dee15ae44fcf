// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "report_page.h"

namespace linelet::powerline::report {

/** \brief A wire closer to the ground or to an object than the limit. */
struct LowWire {
  const Wire* wire;
  const Clearance* found;
  const char* what; ///< what is too close, as text
};

/** \brief All of them, the closest first. */
std::vector<LowWire>
lowWires(const Content& content);

/** \brief A hazard in the 3D view: a line between two places. */
struct SpaceMark {
  Point from, to;   ///< meters, as the network
  std::string key;  ///< identifies it in links
  std::string text; ///< describes it
};

/** \brief Marks of all hazards of the wires as scanned, keyed by c, x or t (clearance,
 * crossing, tree) and their id; if hazards were not searched for, those of \ref
 * lowWires, keyed 1, 2, ... */
std::vector<SpaceMark>
spaceMarks(const Content& content);

/** \brief The link to the hazard with that key in the 3D view. */
inline std::string
spaceLink(const std::string& key)
{
  return "#space-" + key;
}

} // namespace linelet::powerline::report
