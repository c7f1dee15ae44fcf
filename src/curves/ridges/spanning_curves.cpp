// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "spanning_curves.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include <linelet/search/kd_tree.h>

#include "support/groups.h"

namespace linelet {

namespace {

constexpr std::size_t neighbors = 8;

/** \brief The minimum spanning tree of each connected component. */
struct SpanningTrees {
  std::vector<Indices> joined; ///< per point, those it is joined to
  Indices roots;               ///< a point of each tree
};

SpanningTrees
spanningTrees(const Points& points)
{
  struct Link {
    double length;
    Index a, b;
  };
  const KdTree search(points);
  std::vector<Link> links;
  Indices near;
  for (std::size_t i = 0; i < points.size(); ++i) {
    search.nearest(points[i], neighbors + 1, near);
    for (const Index j : near)
      if (j != static_cast<Index>(i))
        links.push_back(
            {(points[j] - points[i]).squaredNorm(), static_cast<Index>(i), j});
  }
  std::sort(links.begin(), links.end(), [](const Link& l, const Link& m) {
    return std::tie(l.length, l.a, l.b) < std::tie(m.length, m.a, m.b);
  });
  Groups groups(points.size());
  SpanningTrees trees;
  trees.joined.resize(points.size());
  for (const Link& link : links) {
    if (!groups.unite(link.a, link.b))
      continue;
    trees.joined[link.a].push_back(link.b);
    trees.joined[link.b].push_back(link.a);
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    if (groups.root(i) == i)
      trees.roots.push_back(static_cast<Index>(i));
  return trees;
}

} // namespace

Traces
spanningCurves(const Points& points, std::size_t least_edges)
{
  const SpanningTrees trees = spanningTrees(points);
  std::vector<char> used(points.size(), 0); // by curves so far
  std::vector<Index> before(points.size()); // on the way from where a search began

  // The longest path from \a start that meets no used point, last point first.
  const auto longestFrom = [&](Index start) {
    std::vector<std::pair<Index, std::size_t>> open{{start, 0}};
    before[start] = start;
    std::pair<Index, std::size_t> last = open.front();
    while (!open.empty()) {
      const auto [at, edges] = open.back();
      open.pop_back();
      if (edges > last.second)
        last = {at, edges};
      for (const Index next : trees.joined[at])
        if (next != before[at] && !used[next]) {
          before[next] = at;
          open.push_back({next, edges + 1});
        }
    }
    Indices way{last.first};
    while (way.back() != start)
      way.push_back(before[way.back()]);
    return way;
  };

  Traces traces;
  Indices branching; // points of curves from which more curves may branch
  const auto keep = [&](const Indices& way) {
    if (way.size() <= least_edges)
      return false;
    ModelCurve curve;
    for (const Index i : way) {
      used[i] = 1;
      branching.push_back(i);
      curve.nodes.push_back(points[i]);
    }
    traces.curves.push_back(std::move(curve));
    return true;
  };
  for (const Index root : trees.roots) {
    keep(longestFrom(longestFrom(root).front()));
    while (!branching.empty()) {
      const Index at = branching.back();
      if (keep(longestFrom(at)))
        traces.meetings.push_back(points[at]);
      else
        branching.pop_back();
    }
  }
  return traces;
}

} // namespace linelet
