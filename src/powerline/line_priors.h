// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>

namespace linelet::powerline {

/** \brief Prior knowledge about real lines. Lengths in meters, evidence in natural
 * logarithms of odds. */
struct LinePriors {
  double tautest = 5000; ///< catenary parameter: ACSR conductors at a fifth of their
                         ///< strength have 1,500 to 2,500, earth wires up to 4,000 in
                         ///< the cold (CIGRE Technical Brochure 324)
  double least_sag = 1.0 / 320; ///< of a span: short wires are strung with more slack,
                                ///< since their length changes with temperature
  double usual_bend = 1e-3; ///< half second derivative, 1 / 2a, of any wire: a = 500 m,
                            ///< between that of a long span and of a service drop
  double bend_spread = 2e-3; ///< its standard deviation
  double usual_joint = 0.1; ///< slopes down on both sides of a support, together: 4 sag
                            ///< / span each, of a sag of 1 to 2 % of the span
  double joint_spread = 0.1; ///< their standard deviation
  double company_reach = 14; ///< largest distance between neighboring wires of a span
  double point_noise = 0.05; ///< of the points about a wire, meters, in proportion to
                             ///< which the priors of its shape count
  double alike = 0.01;       ///< slope between two wires of a span, standard deviation:
                             ///< crossarms differ, and sags by some percent
  /// A span is at most this many times as long as its visible part
  double longer = 1.5;
  double short_line = 25; ///< shortest wire that is sufficient evidence on its own
  double spread = 2.5;    ///< number of standard deviations that rules something out

  /// \name Least evidence of a wire, over that of its surroundings
  /// For some 1e8 positions of a parabola in a square kilometer (18), and four
  /// parameters.
  /// @{
  double alone = 25;
  double in_company = 12; ///< if its line predicts its position
  /// @}

  /// Of the logarithm of the scatter of wires in one scan, at least: the beam meets
  /// them at different angles and distances
  double scatter_spread = 0.15;

  double hidden = 0.3; ///< fraction of a wire hidden by crowns, supports and dropouts

  /// \name What hides a wire also hides the ones right beside it
  /// @{
  double rack = 1;           ///< between wires of a rack or bundle, which share their
                             ///< supports and what hides them; at most
  double hardly_seen = 0.25; ///< of the length of a wire
  double well_seen = 0.75;   ///< of the same stretch of the other
  /// @}

  double open = 0.25;       ///< fraction of a line with an open view to the ground
  double open_itself = 0.5; ///< of each wire: crowns let pulses through, roofs do not

  double guy_slope = 0.45; ///< against the ground, at least, where a guy is anchored
  double guy_reach = 4;    ///< meters from there to where it is seen, at most

  /// \name Service drops
  /// @{
  double longest_drop = 45; ///< a house farther away gets its own pole
  double shortest_drop = 6; ///< poles stand at least across a sidewalk and a front yard
  /// Up to which it is extended to its line; insulators and the pole hide it
  double drop_reach = 6;
  double drop_below = 4;      ///< below the wires of its line, at most
  double drop_beside = 1.5;   ///< and beside them
  double highest_pole = 16;   ///< above ground, of the wires of a line that has drops
  double steepest_drop = 0.8; ///< slope; guys are anchored no farther from their pole
                              ///< than they are attached high
  /// @}

  /** \brief Least half second derivative, 1 / 2a, of a wire that hangs over \a span. */
  double
  leastBend(double span) const
  {
    return 1 / (2 * std::min(tautest, span / (8 * least_sag)));
  }
};

inline constexpr LinePriors priors;

} // namespace linelet::powerline
