// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <bench/scenes/corridor.h>
#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::bench {

/** \brief The rows of the scene matrix. */
enum class SceneKind {
  Standard,      ///< a high-voltage line over fields, trees, houses
  Sparse,        ///< national scan, about 1 point/m2
  Helicopter,    ///< 50 points/m2 and more
  Uav,           ///< 400 points/m2, a distribution line
  Stubs,         ///< a pylon from the UAV, its wires cut after some meters
  Twin,          ///< bundles of two, 0.4 m apart
  Triple,        ///< bundles of three
  Quad,          ///< bundles of four, 0.45 m apart, 4 points per meter of phase in all
  River,         ///< a span of 1,000 m; water returns nothing
  Mountain,      ///< slopes of 30 to 40 degrees
  Street,        ///< wood poles, service drops, trees that touch the wires
  Forest,        ///< a narrow cutting, crowns around the wires, a third hidden
  Crossings,     ///< lines of three voltages one over the other
  Turns,         ///< turns of 60 degrees
  Strips,        ///< misaligned strips
  Clutter,       ///< a line among cranes, gantries, pipe bridges, guyed masts, halls
  Town,          ///< blocks of houses, pole lines along two streets
  ClutterEmpty,  ///< the clutter without a line
  MountainEmpty, ///< bare rock without a line
  TownEmpty,     ///< the town without a line
  ForestEmpty,   ///< closed forest without a line
  WideBeam       ///< sparse, from high up: points lie beside their wire in the beam
};

} // namespace linelet::bench

namespace linelet {

template <>
struct Names<bench::SceneKind> {
  static constexpr std::string_view kind = "scene";
  static constexpr std::array<std::pair<bench::SceneKind, std::string_view>, 22> table =
      {{{bench::SceneKind::Standard, "standard"},
        {bench::SceneKind::Sparse, "sparse"},
        {bench::SceneKind::Helicopter, "helicopter"},
        {bench::SceneKind::Uav, "uav"},
        {bench::SceneKind::Stubs, "stubs"},
        {bench::SceneKind::Twin, "twin"},
        {bench::SceneKind::Triple, "triple"},
        {bench::SceneKind::Quad, "quad"},
        {bench::SceneKind::River, "river"},
        {bench::SceneKind::Mountain, "mountain"},
        {bench::SceneKind::Street, "street"},
        {bench::SceneKind::Forest, "forest"},
        {bench::SceneKind::Crossings, "crossings"},
        {bench::SceneKind::Turns, "turns"},
        {bench::SceneKind::Strips, "strips"},
        {bench::SceneKind::Clutter, "clutter"},
        {bench::SceneKind::Town, "town"},
        {bench::SceneKind::ClutterEmpty, "clutter-empty"},
        {bench::SceneKind::MountainEmpty, "mountain-empty"},
        {bench::SceneKind::TownEmpty, "town-empty"},
        {bench::SceneKind::ForestEmpty, "forest-empty"},
        {bench::SceneKind::WideBeam, "wide-beam"}}};
};

} // namespace linelet

namespace linelet::bench {

/** \brief Which scene, and which parameters of its scan are not left to the seed. Seeds
 * 1 to 99 are for development. Final figures use seeds of 1,000 and more, drawn once at
 * the end; no method is run on them before. */
struct SceneSettings {
  SceneKind kind = SceneKind::Standard;
  std::uint32_t seed = 1;
  double density = 0;      ///< pulses per square meter; 0: by kind and seed
  double wire_density = 0; ///< points per meter of phase in the open; 0: by kind
  double noise = 0;        ///< standard deviation along each axis, meters; 0: by kind
};

/** \brief Names and meaning of the settings; the kind is named apart. */
template <class Visit>
void
describe(SceneSettings& s, Visit&& visit)
{
  visit("seed", s.seed, "the same seed gives the same scene");
  visit("density", s.density, "pulses per square meter; 0: by kind and seed");
  visit("wire-density",
        s.wire_density,
        "points per meter of phase in the open; 0: by kind and seed");
  visit("noise",
        s.noise,
        "standard deviation along each axis, meters; 0: by kind and seed");
}

/** \brief A wire in one span, or the middle of a bundle, where the scan covers it. */
struct SceneWire {
  WireKind kind = WireKind::Conductor;
  int line = 0;             ///< which line of the scene
  int span = 0;             ///< along its line
  int number = 0;           ///< across its span
  int conductors = 1;       ///< of the bundle
  double bundle_radius = 0; ///< distance of the conductors from \ref points, meters
  double noise = 0;         ///< standard deviation of its points, misfit of strips
                            ///< included, meters
  Points points;            ///< vertices about 2 m apart
};

/** \brief What else is long and thin. */
enum class StructureKind {
  Pole,
  Pylon,
  Insulator,
  Jumper, ///< the loop around a tension pylon: a wire, though not one of a span
  Crane,
  Gantry,
  Pipe,
  Guy,
  Fence,
  Rail,
  Trunk,
  Branch,
  Aerial ///< on roofs
};

/** \brief A straight piece of something long and thin that is no wire of a span. */
struct SceneStructure {
  StructureKind kind;
  Point from, to;
  double radius; ///< meters
};

/** \brief A simulated scan with its truth. Points are relative to \ref shift. */
struct SceneScan {
  Point shift = Point::Zero(); ///< world coordinates (ETRS89 / UTM 32N) of the origin
  double density = 0;          ///< pulses per square meter
  double noise = 0;            ///< standard deviation along each axis, meters
  double aside = 0;            ///< largest distance of returns from their wire, meters
  Points points;               ///< in the order of pulses and returns

  /// \name One entry per point
  /// @{
  std::vector<std::uint8_t> classification; ///< truth: 1 crane, gantry, pipe, guy,
                                            ///< fence, rail, 2 ground, 5 vegetation, 6
                                            ///< building, 7 noise, 14 wire and jumper
                                            ///< loop, 15 pylon and pole, 16 insulator
  std::vector<std::uint8_t> return_number, number_of_returns;
  std::vector<std::uint16_t> strip; ///< from 1
  std::vector<std::int32_t> wire;   ///< place in \ref wires, -1: none
  /// @}

  std::vector<SceneWire> wires;
  std::vector<SceneStructure> structures;
};

/** \brief Builds a scene of the matrix and scans it from the air. Pulses come in scan
 * lines whose spacing along and across the flight differs; the flight's heading over
 * the scene, and the scene's heading and location, are drawn. A pulse hits wires,
 * lattice members, leaves, branches, roofs and ground in turn and gives up to five
 * returns. Leaves fill the outer part of a crown, in clumps; branches run inside. A
 * wire is hit within a width that gives its points per meter, whatever the density of
 * the pulses. Deterministic in the settings.
 * \throws std::invalid_argument for a setting out of range
 * \throws Canceled */
SceneScan
simulateScene(const SceneSettings& settings, ProgressMonitor* monitor = nullptr);

} // namespace linelet::bench
