// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <bench/scenes/scene.h>

#include "relief.h"

namespace linelet::bench::scenes {

/** \brief Classes of the truth (ASPRS). */
enum : std::uint8_t {
  OtherClass = 1,
  GroundClass = 2,
  VegetationClass = 5,
  BuildingClass = 6,
  NoiseClass = 7,
  WireClass = 14,
  PylonClass = 15,
  InsulatorClass = 16
};

/** \brief A straight round piece that pulses can hit. */
struct Rod {
  Point from, to;
  double radius;
  double reach; ///< a pulse farther than this from the axis misses it, meters
  double cover; ///< share of a pulse's energy that it takes
  std::uint8_t classification;
  std::int32_t wire = -1;
  double chance = 1;  ///< probability of answering a pulse within reach
  bool aside = false; ///< returns lie on the axis of their pulse
};

/** \brief A flat triangle of a roof or wall. */
struct Facet {
  Point a, b, c;
};

/** \brief Leaves in an ellipsoid, axes along x, y, z: dense outside, sparse inside. */
struct Crown {
  Point center, radii;
  double free_path; ///< mean free path of a pulse between leaves in the sphere, meters
};

/** \brief A disc in plan where nothing else may stand. */
struct Disc {
  double x, y, radius;
};

/** \brief Everything in a scene. x runs along its main line; the extent is [0, length]
 * x [-width/2, width/2]. */
struct World {
  double length, width;
  Relief relief;
  double beam;       ///< radius of a pulse at the objects, meters
  double wire_reach; ///< of a wire that answers every pulse and gives all points of
                     ///< its phase, meters
  bool aside;        ///< a return of a wire lies on the axis of its pulse, up to the
                     ///< radius of the beam beside the wire, not on the wire
  std::vector<Rod> rods;
  std::vector<Facet> facets;
  std::vector<Crown> crowns;
  std::vector<SceneWire> wires; ///< whole spans; clipped to the extent at the end
  std::vector<SceneStructure> structures;
  std::vector<Disc> taken;

  /** \brief Adds a piece of something long and thin, and its truth. */
  void
  add(StructureKind kind, const Point& from, const Point& to, double radius);

  /** \brief Whether a disc is free; if so, it becomes occupied. */
  bool
  take(double x, double y, double radius);

  /** \brief Height of the lowest wire within \a reach of a place (plan); infinite where
   * there is none. */
  double
  lowestWire(double x, double y, double reach) const;
};

} // namespace linelet::bench::scenes
