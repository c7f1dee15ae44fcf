// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::bench {

/** \brief How the crossarms of a simulated pylon carry its six conductors. */
enum class TowerType {
  Any,    ///< the seed decides
  Donau,  ///< two levels: four conductors below, two above
  Barrel, ///< three levels of two
  Level   ///< all six on one level
};

} // namespace linelet::bench

namespace linelet {

template <>
struct Names<bench::TowerType> {
  static constexpr std::string_view kind = "tower type";
  static constexpr std::array<std::pair<bench::TowerType, std::string_view>, 4> table =
      {{{bench::TowerType::Any, "any"},
        {bench::TowerType::Donau, "donau"},
        {bench::TowerType::Barrel, "barrel"},
        {bench::TowerType::Level, "level"}}};
};

} // namespace linelet

namespace linelet::bench {

/** \brief What a simulated corridor holds and how it is scanned. Lengths in meters. */
struct CorridorSettings {
  double length = 500; ///< extent along the flight
  double width = 80;   ///< extent across the flight
  double density = 25; ///< pulses per square meter over all strips
  double altitude = 400;
  double divergence = 0.5;   ///< full opening angle of the beam, mrad
  unsigned strips = 1;       ///< parallel flight lines
  double range_noise = 0.02; ///< standard deviation along the ray
  double strip_error = 0.02; ///< standard deviation of a strip's offset
  double voltage = 110;      ///< kV: sets the size of pylons, spans and bundles
  TowerType tower = TowerType::Any;
  double span = 0;          ///< mean span; 0: by voltage
  double catenary = 0;      ///< catenary constant a of the conductors; 0: by voltage
  unsigned bundle = 0;      ///< subconductors, 1 or 2; 0: by voltage
  unsigned earth_wires = 1; ///< 0 to 2
  double angle = 8;         ///< the line's change of direction at one pylon, degrees
  double wind = 0;          ///< angle by which wind swings the wires, degrees
  unsigned low_voltage = 1; ///< pole lines that cross below the high-voltage line
  unsigned low_voltage_wires = 4;
  double relief = 6;  ///< height differences of the terrain
  double trees = 30;  ///< per hectare
  double bushes = 30; ///< per hectare
  unsigned houses = 6;
  unsigned cranes = 1;
  unsigned fences = 2;
  double gaps = 4;          ///< stretches of wire without returns, per kilometer
  double outliers = 2e-5;   ///< fraction of pulses that return from empty air
  unsigned thin_ground = 1; ///< keep one ground point in n
  unsigned planted = 0;     ///< trees and houses placed too close to wires
  std::uint32_t seed = 1;
};

/** \brief Names and meaning of the settings (see apps/options.h). */
template <class Visit>
void
describe(CorridorSettings& s, Visit&& visit)
{
  visit("length", s.length, "extent along the flight, meters");
  visit("width", s.width, "extent across the flight, meters");
  visit("density", s.density, "pulses per square meter, all strips together");
  visit("altitude", s.altitude, "height of the flight above ground, meters");
  visit("divergence", s.divergence, "full opening angle of the beam, mrad");
  visit("strips", s.strips, "number of parallel flight lines");
  visit("range-noise", s.range_noise, "standard deviation along the ray, meters");
  visit("strip-error", s.strip_error, "standard deviation of a strip's offset, meters");
  visit("voltage", s.voltage, "kV of the line: sizes of pylons, spans, bundles");
  visit("tower", s.tower, "arrangement of the conductors");
  visit("span", s.span, "mean span, meters; 0: by voltage");
  visit(
      "catenary", s.catenary, "catenary constant of conductors, meters; 0: by voltage");
  visit("bundle", s.bundle, "subconductors per bundle, 1 or 2; 0: by voltage");
  visit("earth-wires", s.earth_wires, "number of earth wires, 0 to 2");
  visit("angle", s.angle, "change of direction at one pylon, degrees");
  visit("wind", s.wind, "angle by which wind swings the wires, degrees");
  visit("low-voltage", s.low_voltage, "number of pole lines crossing below");
  visit("low-voltage-wires", s.low_voltage_wires, "wires per pole line, 1 to 6");
  visit("relief", s.relief, "height differences of the terrain, meters");
  visit("trees", s.trees, "trees per hectare");
  visit("bushes", s.bushes, "bushes per hectare");
  visit("houses", s.houses, "number of houses");
  visit("cranes", s.cranes, "number of tower cranes");
  visit("fences", s.fences, "number of fences");
  visit("gaps", s.gaps, "stretches of wire without returns, per kilometer");
  visit("outliers", s.outliers, "fraction of pulses that return from empty air");
  visit("thin-ground", s.thin_ground, "keep one ground point in n");
  visit(
      "planted", s.planted, "trees and houses put too close to wires, .8 to 4 meters");
  visit("seed", s.seed, "the same seed gives the same scene");
}

/** \brief The kind of a true wire. */
enum class WireKind { Conductor, Earth, LowVoltage };

/** \brief A wire of the scene in one span, where the scan covers it. */
struct CorridorWire {
  WireKind kind = WireKind::Conductor;
  int line = 0;   ///< 0: the high-voltage line, then the pole lines
  int span = 0;   ///< along its line
  int number = 0; ///< across its span; subconductors of a bundle share it
  Points points;  ///< vertices about 2 m apart, less than 1 mm off the catenary
  bool front_attached = false; ///< points.front() is an attachment (else: cut by the
                               ///< border of the scan)
  bool back_attached = false;  ///< the same of points.back()
};

/** \brief Something placed too close to a wire. */
struct PlantedHazard {
  std::uint8_t classification = 0; ///< 5 tree, 6 house
  Point wire = Point::Zero();      ///< the nearest place on the wire
  double distance = 0;             ///< from there to its surface, meters
};

/** \brief A simulated scan with its truth. Points are relative to \ref shift. */
struct CorridorScan {
  Point shift = Point::Zero(); ///< world coordinates (ETRS89 / UTM 32N) of the origin
  Points points;               ///< in the order of pulses and returns

  /// \name One entry per point
  /// @{
  std::vector<std::uint8_t> classification; ///< truth: 2 ground, 3 4 5 vegetation, 6
                                            ///< building, 7 noise, 14 wire, 15 pylon,
                                            ///< pole and insulator, 26 crane, fence
  std::vector<std::uint16_t> intensity;
  std::vector<std::uint8_t> return_number, number_of_returns;
  std::vector<float> scan_angle;    ///< degrees, left negative
  std::vector<std::uint16_t> strip; ///< from 1
  std::vector<double> gps_time;     ///< adjusted standard GPS seconds
  std::vector<std::int32_t> wire;   ///< place in \ref wires, -1: none
  /// @}

  std::vector<CorridorWire> wires;
  std::vector<PlantedHazard> planted; ///< as many of CorridorSettings::planted as fit
  double beam_radius = 0; ///< at the altitude: how far a return may lie from its wire
};

/** \brief Builds a corridor with a high-voltage line and scans it from the air.
 *
 * Every pulse is a ray from the moving sensor: it meets wires, lattice members, leaves,
 * roofs and terrain in turn and gives a return where enough of its footprint is
 * covered; the rest continues. As with a real scanner, a return lies on the axis of the
 * beam, so that points of a wire scatter by the radius of the beam. Deterministic in
 * the settings.
 * \throws std::invalid_argument for a setting out of range
 * \throws Canceled */
CorridorScan
simulateCorridor(const CorridorSettings& settings, ProgressMonitor* monitor = nullptr);

} // namespace linelet::bench
