// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <linelet/search/sort_indices.h>
#include <linelet/support/points.h>

namespace linelet {

/** \brief Keeps of \a candidates, squared distance and index, the \a count nearest;
 * among equals the lower indices.
 * \param[in,out] candidates left in any order
 * \param[out] found the indices kept, ascending
 * \return distance of the farthest of them; 0 where there are none */
inline double
keepNearest(std::vector<std::pair<double, Index>>& candidates,
            std::size_t count,
            Indices& found)
{
  using Offset = std::vector<std::pair<double, Index>>::difference_type;
  if (candidates.size() > count) {
    std::nth_element(candidates.begin(),
                     candidates.begin() + static_cast<Offset>(count),
                     candidates.end());
    candidates.resize(count);
  }
  double farthest = 0;
  found.clear();
  for (const auto& [squared, index] : candidates) {
    farthest = std::max(farthest, squared);
    found.push_back(index);
  }
  sortIndices(found);
  return std::sqrt(farthest);
}

} // namespace linelet
