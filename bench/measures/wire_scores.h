// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <bench/scenes/corridor.h>
#include <linelet/curves/curve_network.h>

namespace linelet::bench {

/** \brief What counts as correct when extracted wires are compared with true ones. */
struct WireScoreSettings {
  double step = 0.5;    ///< spacing of samples on the wires, meters
  double near = 0.10;   ///< a true wire is covered if a found one is this near
  double astray = 0.50; ///< a found wire is false if no true one is this near
  double whole = 0.25;  ///< distance and ...
  double share = 0.80;  ///< ... share of a span that one vector must cover to find it
  double shortest = 10; ///< true wires shorter than this are not required: remnants of
                        ///< a span at the border of a scan
};

/** \brief How well extracted wires match the truth. Lengths in meters. */
struct WireScores {
  double true_length = 0;
  double covered_length = 0; ///< of the true wires, within WireScoreSettings::near
  double found_length = 0;
  double false_length = 0;     ///< of the found wires that are far from every true one
  std::size_t spans = 0;       ///< true wires, one per span
  std::size_t spans_found = 0; ///< covered by one vector
  std::vector<double> end_errors; ///< from each attachment of a span that was found to
                                  ///< the nearer end of its vector, ascending

  WireScores&
  operator+=(const WireScores& other);
};

/** \brief Compares extracted wires, one polyline per wire and span, with the truth. One
 * vector along the center of a twin bundle is as correct as two.
 * \param[in] truth in the frame of \a found */
WireScores
scoreWires(const CurveNetwork& found,
           const std::vector<CorridorWire>& truth,
           const WireScoreSettings& settings = {});

/** \brief Agreement of two classifications of the same points in one class. */
struct ClassScores {
  std::size_t right = 0, false_alarms = 0, missed = 0;

  double
  precision() const;
  double
  recall() const;
  /** \brief Harmonic mean of precision and recall; NaN without points. */
  double
  f1() const;

  ClassScores&
  operator+=(const ClassScores& other);
};

/** \brief Compares class \a classification of \a found with \a truth.
 * \param[in] ignored points to leave out (not 0), or empty
 * \throws std::invalid_argument for vectors of different lengths */
ClassScores
scoreClass(const std::vector<std::uint8_t>& found,
           const std::vector<std::uint8_t>& truth,
           std::uint8_t classification,
           const std::vector<std::uint8_t>& ignored = {});

/** \brief Marks every point that lies within \a distance (in plan) of a point of class
 * \a classification: 1, otherwise 0. */
std::vector<std::uint8_t>
nearClass(const Points& points,
          const std::vector<std::uint8_t>& classes,
          std::uint8_t classification,
          double distance);

} // namespace linelet::bench
