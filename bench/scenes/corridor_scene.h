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
  double free_path; ///< mean free path of a beam between leaves, meters
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

  /** \brief Whether a disc is free; if so, it becomes occupied. */
  bool
  take(double x, double y, double radius);
};

} // namespace linelet::bench::corridor
