// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/io/usable_points.h>
#include <linelet/powerline/clearance_limits.h>
#include <linelet/powerline/conductor.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

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

/** \brief What stands near the lines: points that are no ground, wire or own support,
 * each told apart. Found once, for any number of states of the wires. */
struct Surroundings {
  Points points;
  std::vector<HazardKind> kinds; ///< Vegetation, Building or Support
  std::vector<int> support;      ///< id of the support it belongs to, or 0
};

/** \brief What the classes of a file say of its points, ASPRS unless another scheme is
 * told. */
struct SurroundingClasses {
  io::ClassList vegetation{"3,4,5"};
  io::ClassList buildings{"6,17"};
};

template <class Visit>
void
describe(SurroundingClasses& s, Visit&& visit)
{
  visit("vegetation-classes", s.vegetation, "Hazards: classes of trees and bushes");
  visit("building-classes", s.buildings, "Hazards: classes of buildings and bridges");
}

/** \brief Collects what stands near the wires of \a network.
 *
 * A point of one of \a classes is what that says. All others (0, 1 and what is not
 * named here) are told apart by shape and returns: roofs and walls are planar over some
 * meters and give single echoes, masts and booms are linear there, wires that were not
 * found are linear and take no part, the rest is vegetation; fewer than four such
 * points within a meter of each other are a bird or noise. Points of the classes 2, 7,
 * 8, 9, 11, 13 to 16 and 18 are none of them, nor is anything but a building at the
 * bodies, arms and insulators of the supports of a wire.
 * \param[in] cloud what the network was extracted from
 * \param[in] usable its points that take part
 * \param[in] limits how far from a wire is near
 * \throws Canceled */
Surroundings
findSurroundings(const PowerLineNetwork& network,
                 const io::Cloud& cloud,
                 const io::UsablePoints& usable,
                 const ClearanceLimits& limits,
                 const SurroundingClasses& classes = {},
                 unsigned threads = 0,
                 const ProgressMonitor* monitor = nullptr);

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

/** \brief What to look for, and in which states of the conductors. */
struct HazardSettings {
  std::string limits;    ///< see \ref readLimits; empty: PowerLineSettings::clearance
  std::string conductor; ///< see \ref readConductor; empty: no other state
  double conductor_temperature = 15; ///< during the scan, degrees Celsius
  std::vector<std::string> states;   ///< see \ref parseState
  std::vector<double> dead_ends;     ///< ids of supports
  double dead_end_angle = 10;        ///< degrees
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
        "en50341:KV or nesc:KV as starting values; none: --clearance for all");
  visit("conductor",
        s.conductor,
        "Hazards: type of all conductors (Drake, 240/40, ...) or a file of lines 'KEY "
        "VALUE': area (mm2), diameter (mm), mass (kg/km), modulus (GPa), expansion "
        "(1e-6/K), creep (K)");
  visit("conductor-temperature",
        s.conductor_temperature,
        "Hazards: of the conductors during the scan, Celsius");
  visit("state",
        s.states,
        "Hazards: look for hazards also in this state of the conductors: 75C, or "
        "0C,ice=10mm,wind=400Pa; may be given several times");
  visit("dead-ends",
        s.dead_ends,
        "Hazards: ids of pylons where conductors are dead-ended");
  visit("dead-end-angle",
        s.dead_end_angle,
        "Hazards: they are also where a line turns by more, degrees");
  describe(s.classes, visit);
}

/** \brief The hazards of a network as scanned, then in every state that is asked for;
 * of wind from both sides. Ids run on from state to state.
 * \param[in] clearance limit where the settings name none, meters
 * \throws std::invalid_argument, io::FileError, Canceled */
std::vector<Hazards>
findHazardsAtStates(const PowerLineNetwork& network,
                    const io::Cloud& cloud,
                    const io::UsablePoints& usable,
                    const HazardSettings& settings,
                    double clearance,
                    unsigned threads = 0,
                    const ProgressMonitor* monitor = nullptr);

/** \brief The same, where the surroundings are known. */
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

/** \brief Throws what \ref findHazardsAtStates would for its settings, before long
 * work. */
void
check(const HazardSettings& settings);

} // namespace powerline
} // namespace linelet
