// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace linelet::powerline {

/** \brief Prior knowledge about jumpers and insulators. Lengths in meters. */
struct FittingPriors {
  double air_gap = 0.8; ///< between live and earthed parts, at least: below the .9 m of
                        ///< lattice towers' lowest voltage, 100 kV (EN 50341-1:2012,
                        ///< table 5.5), so that within it a conductor is alone
  double half_width = 0.25; ///< of a bundle or a double string: conductors and strings
                            ///< stand .4 to .5 m apart (CIGRE Technical Brochure 273)
  double shortest_string = 0.5; ///< 52 kV; strings of up to six caps and pins of 146 mm
                                ///< (IEC 60305) are hidden by their fittings
  double longest_string = 6;    ///< 800 kV, with its fittings
  double bulky = 3; ///< anything this large and not thin is a structure: yokes, clamps
                    ///< and grading rings measure about 1 m
  double level = 0.5; ///< sine of the least slope of a string that something hangs
                      ///< from: V-strings open up to about 100 degrees
  double longest_jumper = 3; ///< length over the distance between its clamps
  double unseen = 0.1; ///< share of gaps between points of a conductor that may be
                       ///< wider than \ref link; with more, shapes are not seen

  /** \brief Points of one body have neighbors within this distance, points of different
   * bodies do not: less than half of the gap. */
  double
  link() const
  {
    return 0.45 * air_gap;
  }

  /** \brief Longest step along a body that does not reach the next one. */
  double
  stride() const
  {
    return 0.75 * air_gap;
  }

  /** \brief Largest ratio of the two largest standard deviations of the points within
   * \ref air_gap of a thin body: its half width against a line through the ball. */
  double
  thin() const
  {
    return half_width / (air_gap / 1.7320508);
  }
};

} // namespace linelet::powerline
