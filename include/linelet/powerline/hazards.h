// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <linelet/powerline/strain_sections.h>
#include <linelet/powerline/surroundings.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief A stretch of a wire that something is nearer to than its limit. Meters, in
 * the coordinates of the network. */
struct Encroachment {
  int id = 0; ///< place in Hazards::clearances + 1
  HazardKind kind = HazardKind::Ground;
  Severity severity = Severity::Low; ///< by \ref nearest
  int wire = 0, span = 0, circuit = 0;
  int other = 0;           ///< id of the other wire or support; 0 for all other kinds
  double from = 0, to = 0; ///< of the wire's catenary
  double length = 0;       ///< along the wire
  Points line;             ///< the stretch
  Clearance nearest;       ///< where the distance is least
  double vertical = 0, horizontal = 0; ///< parts of that distance; vertical: down
  std::size_t points = 0;              ///< how many were nearer than the limit
  Points outline;    ///< convex, closed, around what is too near, at its mean height
  double area = 0;   ///< in plan of what is too near, square meters (vegetation)
  double volume = 0; ///< of what is to be cut, cubic meters (vegetation)
};

/** \brief A place where two lines cross in plan. */
struct Crossing {
  int id = 0; ///< place in Hazards::crossings + 1
  Severity severity = Severity::None;
  int upper = 0, lower = 0;                                 ///< ids of the wires
  Point upper_at = Point::Zero(), lower_at = Point::Zero(); ///< one above the other
  double vertical = 0;                                      ///< between these
  Clearance nearest;     ///< where the two are closest: on the upper wire, on the lower
  double horizontal = 0; ///< part of the closest distance
  double angle = 0;      ///< between the two in plan, degrees, (0, 90]
};

/** \brief A tree as tall as it is far from a wire: a stiff rod that turns about its
 * foot on the terrain. */
struct FallIn {
  int id = 0; ///< place in Hazards::fall_in + 1
  Severity severity = Severity::Low;
  int wire = 0, span = 0, circuit = 0;
  Point top = Point::Zero(), foot = Point::Zero();
  double height = 0;        ///< top above foot
  Point at = Point::Zero(); ///< the place of the wire that is nearest to the foot
  double distance = 0;      ///< from the foot to that place
  double gap = 0; ///< distance - height: what remains when it has fallen; negative: hit
};

/** \brief What is hazardous along the wires of a network. */
struct Hazards {
  std::string state; ///< of the conductors; "as scanned" where they were not moved
  ClearanceLimits limits;
  std::vector<Encroachment> clearances; ///< by wire and place
  std::vector<Crossing> crossings;      ///< all of them, also those in order
  std::vector<FallIn> fall_in;          ///< the least gap first
  StateOfWires moved; ///< the wires in that state, their Wire::ground measured; without
                      ///< a wire where they hang as scanned
};

/** \brief Every stretch of a wire that is nearer to something than its limit, all
 * crossings, and the trees that would reach a wire by falling.
 *
 * A stretch is the union, over the points of one kind, of the parts of the wire that
 * each is nearer to than the limit; gaps of up to a meter are closed. Distances to the
 * ground are those to the interpolated terrain in space, to other wires those between
 * the curves, to everything else those to its points.
 * \throws Canceled */
Hazards
findHazards(const PowerLineNetwork& network,
            const Surroundings& surroundings,
            const ClearanceLimits& limits,
            unsigned threads = 0,
            const ProgressMonitor* monitor = nullptr);

} // namespace powerline
} // namespace linelet
