// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/piece.h"

#include <algorithm>
#include <limits>

namespace linelet::powerline {

void
updateExtent(Piece& piece, const Points& points)
{
  SpanModel& m = piece.model;
  m.begin = std::numeric_limits<double>::infinity();
  m.end = -m.begin;
  for (const Index i : piece.members) {
    const double s = m.along(points[i]);
    m.begin = std::min(m.begin, s);
    m.end = std::max(m.end, s);
  }
}

} // namespace linelet::powerline
