// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/search/grid_search.h>

#include "sort_indices.h"

namespace linelet {

void
GridSearch::within(const Point& query, double radius, Indices& found) const
{
  found.clear();
  grid_.forEachWithin(query, radius, [&](Index i, double) { found.push_back(i); });
  sortIndices(found);
}

double
GridSearch::nearest(const Point& query, std::size_t count, Indices& found) const
{
  found = grid_.nearestK(query, count);
  if (found.empty())
    return 0;
  const double farthest = (points_[found.back()] - query).norm();
  sortIndices(found);
  return farthest;
}

} // namespace linelet
