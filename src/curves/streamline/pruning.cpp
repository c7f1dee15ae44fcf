// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pruning.h"

#include <vector>

namespace linelet {

void
pruneOpenEnds(LineLets& lets, const CloudNeighbors& neighbors, double distance)
{
  std::vector<bool> pinned(lets.vertices.size(), false);
  for (const auto* pairs : {&lets.united, &lets.links})
    for (const auto& [a, b] : *pairs)
      pinned[a] = pinned[b] = true;

  for (LineLet& line : lets.lines)
    for (const LineLetSide side : {back_side, front_side}) {
      LineLetEnd& end = line.ends[side];
      while (!end.closed && end.vertex != LineLetVertex::none && !pinned[end.vertex]) {
        LineLetVertex& vertex = lets.vertices[end.vertex];
        if (vertex.dropped || // the other end was cut back to here
            neighbors.nearest(vertex.position, distance) != CloudNeighbors::none)
          break;
        vertex.dropped = true;
        end.vertex = side == front_side ? vertex.previous : vertex.next;
      }
    }
}

} // namespace linelet
