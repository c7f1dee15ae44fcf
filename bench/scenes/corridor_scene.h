// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <bench/scenes/corridor.h>
#include <bench/scenes/random.h>

namespace linelet::bench::corridor {

/** \brief Classes of the truth (ASPRS). */
enum : std::uint8_t {
  GroundClass = 2,
  VegetationClass = 5, ///< 3 and 4 by height, once the point is known
  BuildingClass = 6,
  NoiseClass = 7,
  WireClass = 14,
  PylonClass = 15,
  OtherClass = 26
};

/** \brief Rolling terrain: a tilted sum of waves. */
class Terrain {
public:
  Terrain(Random& random, double relief);

  double
  height(double x, double y) const;

private:
  struct Wave {
    double kx, ky, phase, amplitude;
  };
  std::vector<Wave> waves_;
  double slope_x_, slope_y_;
};

/** \brief A straight piece of something round: wire, lattice member, trunk, post. */
struct Member {
  Point from, to;
  double radius;
  std::uint8_t classification;
  float reflectivity;
  std::int32_t wire = -1;
};

/** \brief A flat triangle of a roof or wall. */
struct Panel {
  Point a, b, c;
  std::uint8_t classification;
  float reflectivity;
};

/** \brief An ellipsoid full of leaves, axes along x, y, z. */
struct Crown {
  Point center;
  Point radii;
  double free_path; ///< mean way of a beam between leaves, meters
};

/** \brief Everything that can be hit. x runs along the flight, y to its left; the
 * origin is in the middle of the side where the flight enters. */
struct Scene {
  Terrain terrain;
  std::vector<Member> members;
  std::vector<Panel> panels;
  std::vector<Crown> crowns;
  std::vector<CorridorWire> wires; ///< whole spans; clipped to the scan at the end
  std::vector<Point> keep_clear;   ///< x, y, radius: where nothing else may stand

  void
  beam(const Point& from,
       const Point& to,
       double radius,
       std::uint8_t classification,
       double reflectivity)
  {
    members.push_back(
        {from, to, radius, classification, static_cast<float>(reflectivity), -1});
  }

  /** \brief Height of the lowest wire within \a reach of a place (plan); infinite where
   * there is none. */
  double
  lowestWire(double x, double y, double reach) const;

  /** \brief Whether a disc is free of what must stay clear; if so, it is taken. */
  bool
  take(double x, double y, double radius);
};

/** \brief The high-voltage line from before the scan's start to behind its end. */
void
addHighVoltageLine(Scene& scene, const CorridorSettings& settings, Random& random);

/** \brief A line of poles across the corridor, number \a line (from 1). */
void
addPoleLine(Scene& scene, const CorridorSettings& settings, int line, Random& random);

/** \brief How a wire hangs between two attachments. */
struct WireParameters {
  double a = 1000;        ///< catenary constant, meters
  double wind = 0;        ///< blown out of the vertical, degrees
  double radius = 0.0135; ///< of the wire
  double front_string = 0,
         back_string = 0; ///< insulators in line with the wire, meters
};

/** \brief Adds a wire from attachment to attachment, and the members that a beam can
 * hit. */
void
addWire(Scene& scene,
        CorridorWire wire,
        const Point& from,
        const Point& to,
        const WireParameters& parameters);

/** \brief Lattice of \a panels bays between two squares (four corners each). */
void
addLattice(Scene& scene,
           const Point (&bottom)[4],
           const Point (&top)[4],
           int bays,
           double radius,
           std::uint8_t classification);

/** \brief Takes wire members away so that stretches of wire return nothing. */
void
addGaps(Scene& scene, double per_kilometer, Random& random);

/** \brief Houses, cranes, fences, trees and bushes beside (and some below) the lines.
 */
void
addObjects(Scene& scene, const CorridorSettings& settings, Random& random);

/** \brief Puts trees and houses too near to wires. */
std::vector<PlantedHazard>
plantHazards(Scene& scene, const CorridorSettings& settings, Random& random);

/** \brief Scans the scene strip by strip. Points are those of the scene's own frame. */
CorridorScan
scan(const Scene& scene,
     const CorridorSettings& settings,
     Random& random,
     ProgressMonitor* monitor);

} // namespace linelet::bench::corridor
