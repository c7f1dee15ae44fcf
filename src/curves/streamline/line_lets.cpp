// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "line_lets.h"

#include <cmath>

namespace linelet {

Index
LineLets::add(const LineLetVertex& vertex)
{
  const auto id = static_cast<Index>(vertices.size());
  vertices.push_back(vertex);
  hash_.insert(id, vertex.position);
  return id;
}

Index
LineLets::start(const Point& position, const Point& direction)
{
  const auto id = static_cast<Index>(lines.size());
  LineLetVertex vertex;
  vertex.position = position;
  vertex.line = id;
  LineLet line;
  line.ends[back_side].vertex = line.ends[front_side].vertex = add(vertex);
  line.ends[back_side].direction = -direction;
  line.ends[front_side].direction = direction;
  lines.push_back(line);
  return id;
}

Index
LineLets::branch(Index from, const Point& direction)
{
  const Point position = vertices[from].position;
  const Index id = start(position, direction);
  LineLet& line = lines[id];
  line.origin_line = vertices[from].line;
  line.origin_order = vertices[from].order;
  line.ends[back_side].growing = false;
  line.ends[back_side].closed = true;
  unite(from, line.ends[back_side].vertex);
  return id;
}

Index
LineLets::append(Index line, LineLetSide side, const Point& position)
{
  LineLetEnd& end = lines[line].ends[side];
  LineLetVertex vertex;
  vertex.position = position;
  vertex.line = line;
  vertex.order = vertices[end.vertex].order + (side == front_side ? 1 : -1);
  (side == front_side ? vertex.previous : vertex.next) = end.vertex;
  const Index id = add(vertex);
  LineLetVertex& last = vertices[end.vertex];
  (side == front_side ? last.next : last.previous) = id;
  end.vertex = id;
  return id;
}

Index
LineLets::insertAfter(Index before, const Point& position)
{
  const Index after = vertices[before].next;
  LineLetVertex vertex;
  vertex.position = position;
  vertex.line = vertices[before].line;
  vertex.order = (vertices[before].order + vertices[after].order) / 2;
  vertex.previous = before;
  vertex.next = after;
  const Index id = add(vertex);
  vertices[before].next = vertices[after].previous = id;
  return id;
}

void
LineLets::move(Index vertex, const Point& position)
{
  hash_.erase(vertex, vertices[vertex].position);
  vertices[vertex].position = position;
  hash_.insert(vertex, position);
}

double
LineLets::stepsBetween(Index line, LineLetSide side, Index vertex) const
{
  const LineLet& mine = lines[line];
  const double order = vertices[mine.ends[side].vertex].order;
  const LineLetVertex& other = vertices[vertex];
  const LineLet& theirs = lines[other.line];
  if (other.line == line)
    return std::abs(order - other.order);
  if (mine.origin_line == other.line)
    return std::abs(order) + std::abs(mine.origin_order - other.order);
  if (theirs.origin_line == line)
    return std::abs(other.order) + std::abs(theirs.origin_order - order);
  if (mine.origin_line != LineLetVertex::none && mine.origin_line == theirs.origin_line)
    return std::abs(order) + std::abs(other.order) +
           std::abs(mine.origin_order - theirs.origin_order);
  return std::numeric_limits<double>::infinity();
}

} // namespace linelet
