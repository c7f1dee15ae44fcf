// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "report_page.h"

namespace linelet::powerline::report {

/** \brief A wire that is nearer to the ground or to an object than the limit. */
struct LowWire {
  const Wire* wire;
  const Clearance* found;
  const char* what; ///< that is too close, in words
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

/** \brief Marks of all hazards: those of the wires as scanned, with the keys c, x and t
 * (clearance, crossing, tree) and their ids; without any, those of \ref lowWires, with
 * the keys 1, 2, ... */
std::vector<SpaceMark>
spaceMarks(const Content& content);

/** \brief The link to the hazard of that key in the 3D view. */
inline std::string
spaceLink(const std::string& key)
{
  return "#space-" + key;
}

} // namespace linelet::powerline::report
