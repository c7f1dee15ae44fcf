// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <linelet/curves/curve_network.h>
#include <linelet/support/points.h>

#include "vertex_hash.h"

namespace linelet {

/** \brief A vertex of a line-let, linked to its neighbors on it. */
struct LineLetVertex {
  static constexpr Index none = std::numeric_limits<Index>::max();

  Point position = Point::Zero();
  Index line = none;     ///< the line-let it belongs to
  double order = 0;      ///< steps from the line-let's start, negative going back
  Index previous = none; ///< toward the back end
  Index next = none;     ///< toward the front end
  bool dropped = false;  ///< cut away by pruning
};

/** \brief One end of a line-let. */
struct LineLetEnd {
  Index vertex = LineLetVertex::none; ///< the last vertex on this side
  Point direction = Point::Zero();    ///< unit vector of the last step, outward
  bool growing = true;
  bool closed = false;                ///< joined to a line-let; otherwise open
  EndKind kind = EndKind::Iterations; ///< why an open end stopped
  unsigned steps = 0;
};

/** \brief Back and front of a line-let. */
enum LineLetSide { back_side = 0, front_side = 1 };

/** \brief A piece of a curve that grows from its start in both directions, or from a
 * branch in one. */
struct LineLet {
  std::array<LineLetEnd, 2> ends;          ///< by LineLetSide
  Index origin_line = LineLetVertex::none; ///< the line-let that it branches from
  double origin_order = 0;                 ///< where on it
};

/** \brief The line-lets of a reconstruction while they grow: a graph of vertices. */
class LineLets {
public:
  /** \param[in] cell size of the search cells, about the search distance */
  explicit LineLets(double cell) : hash_(cell) {}

  /** \brief A new line-let at \a position whose front looks along \a direction. */
  Index
  start(const Point& position, const Point& direction);

  /** \brief A new line-let that leaves from the end vertex \a from along \a direction;
   * its back is closed there. */
  Index
  branch(Index from, const Point& direction);

  /** \brief Adds a vertex beyond an end; it becomes the new end. */
  Index
  append(Index line, LineLetSide side, const Point& position);

  /** \brief A vertex at \a position between \a vertex and the next of its line-let. */
  Index
  insertAfter(Index vertex, const Point& position);

  void
  move(Index vertex, const Point& position);

  /** \brief Declares two vertices to be the same. */
  void
  unite(Index a, Index b)
  {
    united.emplace_back(a, b);
  }

  /** \brief Joins two vertices by an edge besides those along the line-lets. */
  void
  link(Index a, Index b)
  {
    links.emplace_back(a, b);
  }

  /** \brief Steps between an end and a vertex along line-lets that grew from another;
   * infinite if there is no such path. */
  double
  stepsBetween(Index line, LineLetSide side, Index vertex) const;

  /** \brief Calls visit(vertex, squared distance) for every vertex within \a radius of
   * \a query; the order depends only on the history of insertions. */
  template <class Visit>
  void
  forEachNear(const Point& query, double radius, Visit&& visit) const
  {
    hash_.forEachNear(query, radius, [&](Index v) {
      const double squared = (vertices[v].position - query).squaredNorm();
      if (squared <= radius * radius)
        visit(v, squared);
    });
  }

  std::vector<LineLetVertex> vertices;
  std::vector<LineLet> lines;
  std::vector<std::pair<Index, Index>> united;
  std::vector<std::pair<Index, Index>> links;

private:
  Index
  add(const LineLetVertex& vertex);

  VertexHash hash_;
};

} // namespace linelet
