// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

#include "powerline/spans/wire_with_ends.h"
#include "support/groups.h"

namespace linelet::powerline {

/** \brief Unites wires that continue each other beyond their supports. */
inline void
unitePartners(Groups& groups, const std::vector<WireWithEnds>& wires)
{
  for (std::size_t w = 0; w < wires.size(); ++w)
    for (const End& end : wires[w].ends)
      if (end.partner >= 0)
        groups.unite(w, static_cast<std::size_t>(end.partner));
}

/** \brief Unites all wires \a a and \a b with \a together(a, b), which is called only
 * for wires whose extents along x are at most \a reach meters apart. */
template <class Together>
void
uniteNeighbors(Groups& groups,
               const std::vector<WireWithEnds>& wires,
               double reach,
               Together&& together)
{
  const auto left = [&](std::size_t w) {
    return std::min(wires[w].ends[0].place.x(), wires[w].ends[1].place.x());
  };
  const auto right = [&](std::size_t w) {
    return std::max(wires[w].ends[0].place.x(), wires[w].ends[1].place.x());
  };
  const std::size_t n = wires.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(left(a), a) < std::tuple(left(b), b);
  });
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i + 1; k < n && left(order[k]) <= right(order[i]) + reach; ++k)
      if (together(wires[order[i]], wires[order[k]]))
        groups.unite(order[i], order[k]);
}

} // namespace linelet::powerline
