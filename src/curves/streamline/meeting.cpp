// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "meeting.h"

#include <cmath>
#include <limits>

namespace linelet {

namespace {

constexpr Index none = LineLetVertex::none;
// A line-let's own last steps, and those it branched from, do not count as encounters.
constexpr double near_steps = 5;

/** \brief The open end whose last vertex is \a vertex, or null. */
LineLetEnd*
openEndAt(LineLets& lets, Index vertex)
{
  for (LineLetEnd& end : lets.lines[lets.vertices[vertex].line].ends)
    if (end.vertex == vertex && !end.closed)
      return &end;
  return nullptr;
}

void
close(LineLetEnd& end)
{
  end.growing = false;
  end.closed = true;
}

/** \brief The vertex on the segments around \a nearest at which an end that arrives at
 * \a at along \a direction crosses them. */
Index
crossingVertex(LineLets& lets, Index nearest, const Point& at, const Point& direction)
{
  const LineLetVertex middle = lets.vertices[nearest];
  Index best_before = none; // start of the crossed segment
  double best_parameter = 0, best_gap = std::numeric_limits<double>::infinity();
  for (const Index before : {middle.previous, nearest}) {
    if (before == none || lets.vertices[before].next == none)
      continue;
    const Point a = lets.vertices[before].position;
    const Point edge = lets.vertices[lets.vertices[before].next].position - a;
    const SkewLines closest = closestOnSkewLines(at, direction, a, edge);
    if (closest.parallel || closest.on_second < 0 || closest.on_second > 1)
      continue;
    const double gap = (a + closest.on_second * edge - at).squaredNorm();
    if (gap < best_gap) {
      best_gap = gap;
      best_before = before;
      best_parameter = closest.on_second;
    }
  }
  if (best_before != none) {
    const Point a = lets.vertices[best_before].position;
    const Index after = lets.vertices[best_before].next;
    const Point b = lets.vertices[after].position;
    // There already is a vertex at the very end of a segment.
    if (best_parameter < 0.01)
      return best_before;
    if (best_parameter > 0.99)
      return after;
    return lets.insertAfter(best_before, a + best_parameter * (b - a));
  }
  Index best = nearest;
  for (const Index v : {middle.previous, middle.next})
    if (v != none && (lets.vertices[v].position - at).squaredNorm() <
                         (lets.vertices[best].position - at).squaredNorm())
      best = v;
  return best;
}

} // namespace

SkewLines
closestOnSkewLines(const Point& a, const Point& u, const Point& b, const Point& v)
{
  const Point w = a - b;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const double determinant = uu * vv - uv * uv; // |u x v|^2
  SkewLines result;
  if (!(determinant > 1e-12 * uu * vv)) {
    result.parallel = true;
    return result;
  }
  result.on_first = (uv * v.dot(w) - vv * u.dot(w)) / determinant;
  result.on_second = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
  return result;
}

bool
meet(LineLets& lets, Index line, LineLetSide side, double distance)
{
  LineLetEnd& mine = lets.lines[line].ends[side];
  const Point at = lets.vertices[mine.vertex].position;
  Index nearest_end = none, nearest = none;
  double end_squared = std::numeric_limits<double>::infinity(),
         squared_best = end_squared;
  lets.forEachNear(at, distance, [&](Index v, double squared) {
    if (lets.stepsBetween(line, side, v) < near_steps)
      return;
    if (squared < end_squared && openEndAt(lets, v) != nullptr) {
      end_squared = squared;
      nearest_end = v;
    }
    if (squared < squared_best) {
      squared_best = squared;
      nearest = v;
    }
  });
  if (nearest_end != none) {
    const Point mean = (at + lets.vertices[nearest_end].position) / 2;
    close(*openEndAt(lets, nearest_end));
    close(mine);
    lets.unite(mine.vertex, nearest_end);
    lets.move(mine.vertex, mean);
    lets.move(nearest_end, mean);
    return true;
  }
  if (nearest == none)
    return false;
  close(mine);
  lets.link(mine.vertex, crossingVertex(lets, nearest, at, mine.direction));
  return true;
}

} // namespace linelet
