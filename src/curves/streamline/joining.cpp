// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "joining.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace linelet {

namespace {

/** \brief Which vertices are the same, as a disjoint-set forest. */
class Unions {
public:
  explicit Unions(std::size_t count) : parent_(count)
  {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  Index
  find(Index v)
  {
    while (parent_[v] != v)
      v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  void
  unite(Index a, Index b)
  {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<Index> parent_;
};

/** \brief The graph of the line-lets' vertices and edges. */
class LineLetGraph {
public:
  explicit LineLetGraph(const LineLets& lets)
      : lets_(lets), neighbors_(lets.vertices.size()), free_kind_(lets.vertices.size())
  {
    Unions unions(lets.vertices.size());
    for (const auto& [a, b] : lets.united)
      unions.unite(a, b);
    const auto add = [&](Index a, Index b) {
      if (lets.vertices[a].dropped || lets.vertices[b].dropped)
        return;
      a = unions.find(a);
      b = unions.find(b);
      if (a == b || std::count(neighbors_[a].begin(), neighbors_[a].end(), b) > 0)
        return;
      neighbors_[a].push_back(b);
      neighbors_[b].push_back(a);
    };
    for (Index v = 0; v < lets.vertices.size(); ++v)
      if (lets.vertices[v].next != LineLetVertex::none)
        add(v, lets.vertices[v].next);
    for (const auto& [a, b] : lets.links)
      add(a, b);
    std::fill(free_kind_.begin(), free_kind_.end(), EndKind::Support);
    for (const LineLet& line : lets.lines)
      for (const LineLetEnd& end : line.ends)
        if (!end.closed && end.vertex != LineLetVertex::none)
          free_kind_[unions.find(end.vertex)] = end.kind;
  }

  /** \brief A run of vertices between two that are not pass-through, or a closed
   * one. */
  struct Path {
    Indices vertices; ///< a closed one does not repeat its first
    bool closed = false;
    double length = 0;
  };

  /** \brief All paths, each once. */
  std::vector<Path>
  paths() const
  {
    std::vector<Path> result;
    std::vector<bool> passed(neighbors_.size(), false); // pass-through vertices
    for (Index v = 0; v < neighbors_.size(); ++v)
      if (neighbors_[v].size() != 2)
        for (const Index first : neighbors_[v])
          if (neighbors_[first].size() == 2 ? !passed[first] : v < first)
            result.push_back(follow(v, first, passed));
    for (Index v = 0; v < neighbors_.size(); ++v)
      if (neighbors_[v].size() == 2 && !passed[v]) {
        result.push_back(follow(v, neighbors_[v].front(), passed));
        result.back().closed = true;
        result.back().vertices.pop_back(); // the first again
      }
    return result;
  }

  /** \brief Removes every path with a free end that is shorter than \a length.
   * \return whether there was one */
  bool
  dropStumps(double length)
  {
    bool any = false;
    for (const Path& path : paths()) {
      const std::size_t front = degree(path.vertices.front());
      const std::size_t back = degree(path.vertices.back());
      if (path.closed || (front != 1 && back != 1) || path.length >= length)
        continue;
      for (std::size_t i = 1; i < path.vertices.size(); ++i)
        cut(path.vertices[i - 1], path.vertices[i]);
      any = true;
    }
    return any;
  }

  std::size_t
  degree(Index v) const
  {
    return neighbors_[v].size();
  }

  EndKind
  freeKind(Index v) const
  {
    return free_kind_[v];
  }

private:
  Path
  follow(Index from, Index to, std::vector<bool>& passed) const
  {
    Path path;
    path.vertices = {from};
    for (const Index begin = from;;) {
      path.vertices.push_back(to);
      path.length +=
          (lets_.vertices[to].position - lets_.vertices[from].position).norm();
      if (neighbors_[to].size() != 2)
        return path;
      passed[to] = true;
      if (to == begin)
        return path;
      const Index next =
          neighbors_[to][0] == from ? neighbors_[to][1] : neighbors_[to][0];
      from = to;
      to = next;
    }
  }

  void
  cut(Index a, Index b)
  {
    const auto erase = [](Indices& from, Index what) {
      from.erase(std::find(from.begin(), from.end(), what));
    };
    erase(neighbors_[a], b);
    erase(neighbors_[b], a);
  }

  const LineLets& lets_;
  std::vector<Indices> neighbors_;
  std::vector<EndKind> free_kind_;
};

} // namespace

CurveNetwork
join(const LineLets& lets, double stump_length)
{
  LineLetGraph graph(lets);
  while (graph.dropStumps(stump_length)) {
  }
  CurveNetwork network;
  std::vector<int> junction_of(lets.vertices.size(), -1);
  const auto endAt = [&](Index v, std::size_t curve) {
    CurveEnd end;
    if (graph.degree(v) == 1) {
      end.kind = graph.freeKind(v);
      return end;
    }
    if (junction_of[v] < 0) {
      junction_of[v] = static_cast<int>(network.junctions.size());
      network.junctions.push_back({lets.vertices[v].position, {}});
    }
    end.kind = EndKind::Junction;
    end.junction = junction_of[v];
    auto& curves = network.junctions[static_cast<std::size_t>(end.junction)].curves;
    if (curves.empty() || curves.back() != curve) // a loop returns to its junction
      curves.push_back(curve);
    return end;
  };
  for (const auto& path : graph.paths()) {
    Curve curve;
    for (const Index v : path.vertices)
      curve.points.push_back(lets.vertices[v].position);
    curve.closed = path.closed;
    if (path.closed)
      curve.front.kind = curve.back.kind = EndKind::Loop;
    else {
      curve.front = endAt(path.vertices.front(), network.curves.size());
      curve.back = endAt(path.vertices.back(), network.curves.size());
    }
    network.curves.push_back(std::move(curve));
  }
  return network;
}

} // namespace linelet
