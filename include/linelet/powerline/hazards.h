// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <linelet/powerline/clearance_limits.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline/strain_sections.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief A stretch of a wire that is closer to something than its limit allows.
 * Meters, in the coordinates of the network. */
struct Encroachment {
  int id = 0; ///< index in Hazards::clearances + 1
  HazardKind kind = HazardKind::Ground;
  Severity severity = Severity::Low; ///< by \ref nearest
  int wire = 0, span = 0, circuit = 0;
  int other = 0;           ///< id of the other wire or support; 0 for other kinds
  double from = 0, to = 0; ///< parameters s of the wire's catenary
  double length = 0;       ///< along the wire
  Points line;             ///< the stretch
  Clearance nearest;       ///< where the distance is smallest
  double vertical = 0,
         horizontal = 0;  ///< components of that distance; vertical: downward
  std::size_t points = 0; ///< number of points closer than the limit
  Points outline;    ///< convex, closed, around what is too close, at its mean height
  double area = 0;   ///< in plan of what is too close (vegetation), square meters
  double volume = 0; ///< of what must be cut (vegetation), cubic meters
};

/** \brief A place where two lines cross in plan. */
struct Crossing {
  int id = 0; ///< index in Hazards::crossings + 1
  Severity severity = Severity::None;
  int upper = 0, lower = 0;                                 ///< ids of the wires
  Point upper_at = Point::Zero(), lower_at = Point::Zero(); ///< one above the other
  double vertical = 0;                                      ///< between these
  /// Where the two are closest: a point on each wire, the upper first
  Clearance nearest;
  double horizontal = 0; ///< component of the smallest distance
  double angle = 0;      ///< between the two in plan, degrees, (0, 90]
};

/** \brief A tree that could reach a wire by falling: a rigid rod that turns about its
 * foot on the terrain. */
struct FallIn {
  int id = 0; ///< index in Hazards::fall_in + 1
  Severity severity = Severity::Low;
  int wire = 0, span = 0, circuit = 0;
  Point top = Point::Zero(), foot = Point::Zero();
  double height = 0;        ///< top above foot
  Point at = Point::Zero(); ///< point of the wire nearest to the foot
  double distance = 0;      ///< from the foot to that place
  double gap = 0; ///< distance - height: what remains once it has fallen; negative: it
                  ///< hits the wire
};

/** \brief What is hazardous along the wires of a network. */
struct Hazards {
  std::string state; ///< of the conductors; "as scanned" if they were not moved
  ClearanceLimits limits;
  std::vector<Encroachment> clearances; ///< by wire and place
  std::vector<Crossing> crossings;      ///< all of them, hazardous or not
  std::vector<FallIn> fall_in;          ///< smallest gap first
  StateOfWires moved; ///< the wires in that state, with Wire::ground measured; empty
                      ///< for the state as scanned
};

} // namespace powerline
} // namespace linelet
