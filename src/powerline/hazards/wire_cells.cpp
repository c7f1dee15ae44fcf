// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/hazards/wire_cells.h"

#include <algorithm>

namespace linelet::powerline {

WireCells::WireCells(const std::vector<Wire>& wires, double reach) : side_(reach)
{
  for (std::size_t w = 0; w < wires.size(); ++w) {
    // Every vertex takes the cells around it; they are at most half a cell apart.
    const Catenary& c = wires[w].curve;
    const int steps =
        std::max(1, static_cast<int>(std::ceil((c.to - c.from) / (0.5 * side_))));
    for (int k = 0; k <= steps; ++k) {
      const Point p = c.at(c.from + (c.to - c.from) * k / steps);
      for (std::int64_t column = cell(p.x() - 1.25 * side_);
           column <= cell(p.x() + 1.25 * side_);
           ++column)
        for (std::int64_t row = cell(p.y() - 1.25 * side_);
             row <= cell(p.y() + 1.25 * side_);
             ++row) {
          auto& here = cells_[key(column, row)];
          if (here.empty() || here.back() != w)
            here.push_back(static_cast<std::uint32_t>(w));
        }
    }
  }
}

} // namespace linelet::powerline
