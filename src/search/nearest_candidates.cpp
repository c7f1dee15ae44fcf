// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/search/nearest_candidates.h>

#include <algorithm>
#include <cmath>

#include "sort_indices.h"

namespace linelet {

double
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
