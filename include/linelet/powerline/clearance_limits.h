// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <linelet/support/names.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief What comes too close to a wire. */
enum class HazardKind : std::uint8_t {
  Ground,     ///< the terrain
  Vegetation, ///< trees, bushes
  Building,   ///< houses, masts, booms: anything smooth and closed, or stiff and thin
  Wire,       ///< a wire of another line
  Support,    ///< a pylon or pole of another line
  FallIn      ///< a tree that would reach the wire by falling
};

constexpr std::size_t hazard_kinds = 6;

/** \brief How close it is, by the limits for its kind. */
enum class Severity : std::uint8_t { None, Low, Medium, High };

/** \brief Smallest acceptable distances, by what is near and by severity; meters.
 *
 * For all kinds but FallIn a distance below \ref Row::low is a hazard. For FallIn it is
 * the gap that remains between the falling tree and the wire; at 0 it touches. */
struct ClearanceLimits {
  /** \brief Distances below which the severity is high, medium, low; ascending. */
  struct Row {
    double high = 0, medium = 0, low = 0;
  };

  std::string name; ///< where they come from, as text
  std::array<Row, hazard_kinds> rows;

  const Row&
  of(HazardKind kind) const
  {
    return rows[static_cast<std::size_t>(kind)];
  }

  Severity
  severity(HazardKind kind, double distance) const;

  /** \brief The largest distance at which anything beside a wire is a hazard. */
  double
  largest() const;
};

/** \brief One distance for everything: low below \a clearance, medium below three
 * quarters of it, high below half; for falling trees 2, 1 and 0 m. */
ClearanceLimits
uniformLimits(double clearance);

/** \brief Limits by name, or from a file.
 *
 * - "en50341:KV": EN 50341-1:2012, clause 5 and 5.9, empirical distances Del and Dpp
 * for the nominal voltage KV (3 to 750): ground 5 m + Del (at least 6), trees 1.5 m +
 * Del, buildings 4 m + Del (at least 5), other lines 1 m + Dpp (at least 2), their
 * supports 2 m + Del (at least 3). National annexes differ.
 * - "nesc:KV": ground by NESC (IEEE C2) rule 232, 18.5 ft plus 0.4 in per kV above 22
 * kV phase to ground; buildings and other lines likewise from 7.5 ft and 4 ft; trees by
 * California's General Order 95, appendix E (4, 6, 10 and 15 ft).
 * - otherwise a file: one line "KIND HIGH MEDIUM LOW" each for ground, vegetation,
 *   building, wire, support and fall_in, in meters; # begins a comment. Kinds it omits
 *   are taken from \a otherwise.
 *
 * These standards apply to specific load cases, with conditions that no point cloud
 * shows: the presets are starting values, not proof of compliance. Their margins
 * (between medium and low) are our own.
 * \throws std::invalid_argument naming the line and value; io::FileError */
ClearanceLimits
readLimits(const std::string& name_or_file, const ClearanceLimits& otherwise);

} // namespace powerline

template <>
struct Names<powerline::HazardKind> {
  static constexpr std::string_view kind = "hazard kind";
  static constexpr std::array<std::pair<powerline::HazardKind, std::string_view>, 6>
      table = {{{powerline::HazardKind::Ground, "ground"},
                {powerline::HazardKind::Vegetation, "vegetation"},
                {powerline::HazardKind::Building, "building"},
                {powerline::HazardKind::Wire, "wire"},
                {powerline::HazardKind::Support, "support"},
                {powerline::HazardKind::FallIn, "fall_in"}}};
};

template <>
struct Names<powerline::Severity> {
  static constexpr std::string_view kind = "severity";
  static constexpr std::array<std::pair<powerline::Severity, std::string_view>, 4>
      table = {{{powerline::Severity::None, "none"},
                {powerline::Severity::Low, "low"},
                {powerline::Severity::Medium, "medium"},
                {powerline::Severity::High, "high"}}};
};

} // namespace linelet
