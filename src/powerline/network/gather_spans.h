// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

/** \brief Where a line continues beyond one end of a span. */
struct Next {
  int span = -1; ///< index in the list of spans, -1: the line ends
  int side = 0;  ///< the end of that span that is met
};

/** \brief A span that is not numbered yet: its wires, and the next span at either end.
 * End 0 is where its first wire begins. */
struct WiresOfSpan {
  std::vector<std::size_t> wires;      ///< indices in the list of wires
  std::vector<char> reversed;          ///< wire runs from end 1 to end 0
  std::array<int, 2> support = {0, 0}; ///< ids, 0: none seen
  std::array<Next, 2> next;
};

/** \brief Gathers wires between the same two supports, or side by side where supports
 * are not seen, and links the spans that follow each other in a line. */
std::vector<WiresOfSpan>
gatherSpans(const std::vector<WireWithEnds>& wires);

} // namespace linelet::powerline
