// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "connected_components.h"

#include <algorithm>

#include <linelet/search/uniform_grid.h>

#include "occupied_cells.h"
#include "support/groups.h"

namespace linelet {

namespace {

// In link distances: all points of a cell with this side are linked, as it is a little
// less than 1 / sqrt(3).
constexpr double cell_side = 0.577;

} // namespace

std::vector<Indices>
connectedComponents(const Points& points,
                    double distance,
                    std::size_t least,
                    const ScaleField* scales)
{
  const OccupiedCells cells = occupiedCells(points, cell_side * distance);
  std::vector<double> reach(points.size(), distance), widest(cells.size(), distance);
  Points first; // of each cell
  for (std::size_t c = 0; c < cells.size(); ++c) {
    first.push_back(points[cells.indices[cells.begin[c]]]);
    for (std::size_t k = cells.begin[c]; scales && k < cells.begin[c + 1]; ++k) {
      const Index i = cells.indices[k];
      reach[i] *= std::max(1.0, scales->at(points[i]));
      widest[c] = std::max(widest[c], reach[i]);
    }
  }
  const auto linked = [&](std::size_t a, std::size_t b) {
    for (std::size_t k = cells.begin[a]; k < cells.begin[a + 1]; ++k)
      for (std::size_t l = cells.begin[b]; l < cells.begin[b + 1]; ++l) {
        const Index i = cells.indices[k], j = cells.indices[l];
        if ((points[i] - points[j]).squaredNorm() <= reach[i] * reach[i])
          return true;
      }
    return false;
  };

  Groups joined(cells.size()); // cells
  const UniformGrid grid(first, 2 * distance);
  for (std::size_t a = 0; a < cells.size(); ++a)
    grid.forEachWithin(
        first[a], distance, [&](Index b, double) { joined.unite(a, b); });
  // All points are compared only where that may still join two components.
  for (std::size_t a = 0; a < cells.size(); ++a)
    grid.forEachWithin(first[a], widest[a] + 2 * distance, [&](Index b, double) {
      if (joined.root(a) != joined.root(b) && linked(a, b))
        joined.unite(a, b);
    });

  std::vector<std::size_t> component_of(points.size(), cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t k = cells.begin[c]; k < cells.begin[c + 1]; ++k)
      component_of[cells.indices[k]] = joined.root(c);
  std::vector<Indices> members(cells.size()), components;
  std::vector<std::size_t> order; // of the components, by their first points
  for (std::size_t i = 0; i < points.size(); ++i)
    if (component_of[i] < cells.size()) {
      if (members[component_of[i]].empty())
        order.push_back(component_of[i]);
      members[component_of[i]].push_back(static_cast<Index>(i));
    }
  for (const std::size_t component : order)
    if (members[component].size() >= least)
      components.push_back(std::move(members[component]));
  return components;
}

} // namespace linelet
