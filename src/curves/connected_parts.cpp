// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <numeric>

#include <linelet/curves/refined_part.h>
#include <linelet/search/uniform_grid.h>

namespace linelet {

std::vector<Indices>
connectedParts(const Points& points,
               double distance,
               std::size_t least,
               const ScaleField* scales)
{
  const UniformGrid grid(points, distance);
  std::vector<std::size_t> root(points.size());
  std::iota(root.begin(), root.end(), std::size_t(0));
  const auto rootOf = [&](std::size_t i) {
    while (root[i] != i)
      i = root[i] = root[root[i]];
    return i;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double wider = scales ? std::max(1.0, scales->at(points[i])) : 1;
    grid.forEachWithin(points[i], wider * distance, [&](Index j, double) {
      const std::size_t a = rootOf(i), b = rootOf(j);
      root[std::max(a, b)] = std::min(a, b);
    });
  }
  std::vector<Indices> all(points.size()), parts;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      all[rootOf(i)].push_back(static_cast<Index>(i));
  for (Indices& members : all)
    if (members.size() >= least)
      parts.push_back(std::move(members));
  return parts;
}

} // namespace linelet
