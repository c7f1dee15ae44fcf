// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/search/subset_search.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include <linelet/search/nearest_candidates.h>

namespace linelet {

SubsetSearch::SubsetSearch(const NeighborSearch& whole,
                           const Points& points,
                           const Indices& chosen)
    : whole_(whole),
      points_(points),
      findable_(static_cast<std::size_t>(std::count_if(
          points.begin(), points.end(), [](const Point& p) { return p.allFinite(); }))),
      begin_(points.size() + 1, 0),
      places_(chosen.size())
{
  for (const Index i : chosen) {
    if (i >= points.size())
      throw std::invalid_argument("index " + std::to_string(i) + " is not one of the " +
                                  std::to_string(points.size()) + " points");
    ++begin_[i + 1];
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    begin_[i + 1] += begin_[i];
  std::vector<Index> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t place = 0; place < chosen.size(); ++place)
    places_[next[chosen[place]]++] = static_cast<Index>(place);
}

template <class Visit>
void
SubsetSearch::forEachPlace(const Indices& found, Visit&& visit) const
{
  for (const Index i : found)
    for (Index k = begin_[i]; k < begin_[i + 1]; ++k)
      visit(i, places_[k]);
}

void
SubsetSearch::within(const Point& query, double radius, Indices& found) const
{
  thread_local Indices all;
  whole_.within(query, radius, all);
  found.clear();
  forEachPlace(all, [&](Index, Index place) { found.push_back(place); });
  std::sort(found.begin(), found.end());
}

double
SubsetSearch::nearest(const Point& query, std::size_t count, Indices& found) const
{
  found.clear();
  if (count == 0 || !query.allFinite())
    return 0;
  thread_local Indices all;
  thread_local std::vector<std::pair<double, Index>> candidates;
  for (std::size_t asked = std::min(count, findable_);; asked *= 2) {
    asked = std::min(asked, findable_);
    const double distance = whole_.nearest(query, asked, all);
    candidates.clear();
    // More points, of higher index, may be as far as the last one.
    if (asked < findable_)
      whole_.within(query, distance * (1 + 1e-12), all);
    forEachPlace(all, [&](Index i, Index place) {
      candidates.emplace_back((points_[i] - query).squaredNorm(), place);
    });
    if (candidates.size() >= count || asked == findable_)
      return keepNearest(candidates, count, found);
  }
}

} // namespace linelet
