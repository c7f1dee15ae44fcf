// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "powerline/pieces/evidence.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

constexpr double steep = 0.12;      ///< slope between the ends
constexpr double clear_bend = 2e-4; ///< z2 of a line so short that it hangs from poles
constexpr double long_line = 60;    ///< meters from which a line is sufficient evidence
constexpr std::size_t many = 4;     ///< wires of a family that prove each other
constexpr double lone_cover = 0.5;  ///< of the bins of a line inside the data

/** Wires that run side by side or continue each other: they support each other's
 * evidence. */
struct Family {
  std::size_t wires = 0;
  double longest = 0;              ///< longest chain of joined wires, meters
  double single = 0;               ///< longest wire, meters
  double bend = 0, weight = 0;     ///< sums over the wires, weighted by length
  double bends = 0, precision = 0; ///< of the points alone, weighted by precision
  double least = 0;                ///< lower bound of the bends, with the same weights
  double open = 0, length = 0; ///< length with an open view to the ground; of all wires
  double clean = 0, occupied = 0, bins = 0; ///< sums of the evidence of short chains
  bool drop = false;                        ///< a wire leaves another line
  bool border = false;                      ///< a wire leaves the data
  bool clear = false;  ///< a wire hangs alone with a free view to the ground
  bool joined = false; ///< some wires meet
  double stubs = 0;    ///< pairs that meet at a support, cut off by the data's border
  double descent = 0;  ///< sum of their slopes away from it
  /// Evidence (nats) that its wires run straight on where they meet
  double unbroken = 0;
};

/** \brief Adds the bend of \a wire as its points measure it. */
void
addBend(Family& family,
        const WireWithEnds& wire,
        const Points& points,
        const Underside& underside);

/** \brief Adds how \a wires[w] and the wires that it meets at supports slope down to
 * both sides, if both are cut off by the border of the data. */
void
addDescent(Family& family,
           const std::vector<WireWithEnds>& wires,
           std::size_t w,
           const Underside& underside);

/** \brief Adds how \a wires[w] and its continuations bend down where they meet: wires
 * do so at their supports, the pieces of a pipe or beam do not. */
void
addJoints(Family& family, const std::vector<WireWithEnds>& wires, std::size_t w);

/** \brief Adds the evidence of a wire of a short chain. */
void
addEvidence(Family& family,
            const SpanModel& m,
            const Evidence& evidence,
            const Underside& underside);

/** \brief Whether \a family may be wires.
 * \param[in] terrain whether the cloud shows terrain: lines then hang clear of it */
bool
plausible(const Family& family, bool terrain);

} // namespace linelet::powerline
