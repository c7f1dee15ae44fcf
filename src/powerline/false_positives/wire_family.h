// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "powerline/pieces/bend.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

constexpr double long_line = 60; ///< meters, from which a line is evidence enough

/** Wires that run side by side or continue each other: they support each other's
 * evidence. */
struct Family {
  std::size_t wires = 0;
  double longest = 0;              ///< longest chain of joined wires, meters
  double single = 0;               ///< longest wire, meters
  double bends = 0, precision = 0; ///< of the points alone, weighted by precision
  bool drop = false;               ///< a wire leaves another line
  bool border = false;             ///< a wire leaves the data
  /// Evidence (nats) that its wires run straight on where they meet
  double unbroken = 0;
};

/** \brief Adds the bend of a wire as its points measure it. */
void
addBend(Family& family, const Bend& bend);

/** \brief Adds how \a wires[w] and its continuations bend down where they meet: wires
 * do so at their supports, the pieces of a pipe or beam do not. */
void
addJoints(Family& family, const std::vector<WireWithEnds>& wires, std::size_t w);

/** \brief Whether \a family may be wires. */
bool
plausible(const Family& family);

} // namespace linelet::powerline
