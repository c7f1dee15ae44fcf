// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curve_grid.h"

#include <algorithm>

#include "layout.h"

namespace linelet::io::hdf5 {

namespace {

const std::string lines_group = curves_grid + "/Lines";
const std::string junctions_group = curves_grid + "/Junctions";

Handle
pointsGroup(const Handle& file,
            const std::string& name,
            const Points& points,
            const Point& shift,
            const std::string& wkt)
{
  Handle group = createGroup(file, name);
  setAttribute(group, "shift", std::vector<double>{shift.x(), shift.y(), shift.z()});
  if (!wkt.empty())
    setAttribute(group, "wkt", wkt);
  std::vector<double> xyz;
  for (const Point& p : points)
    xyz.insert(xyz.end(), p.data(), p.data() + 3);
  positionColumn(group).append(xyz.data(), points.size());
  return group;
}

/** \brief The positions of \a group in world coordinates. */
Points
pointsOf(const Handle& group)
{
  const Point shift(numbersAttribute(group, "shift", 3).data());
  const StoredColumn column(group, positions);
  Points points(column.rows(), shift);
  std::vector<double> values(column.rows());
  for (int axis = 0; axis < 3; ++axis) {
    const Member& member = positionMembers()[static_cast<std::size_t>(axis)];
    column.read(member, 0, values.size(), values.data());
    for (std::size_t i = 0; i < values.size(); ++i)
      points[i][axis] += values[i];
  }
  return points;
}

template <class Get>
void
writeIntegers(const Handle& group,
              const char* name,
              const std::vector<Curve>& curves,
              const Get& get)
{
  std::vector<std::int64_t> values;
  values.reserve(curves.size());
  for (const Curve& curve : curves)
    values.push_back(static_cast<std::int64_t>(get(curve)));
  writeValues(group, name, ValueType::Int64, values);
}

void
writeNumbers(const Handle& group,
             const char* name,
             const std::vector<Curve>& curves,
             double Curve::*member)
{
  std::vector<double> values;
  values.reserve(curves.size());
  for (const Curve& curve : curves)
    values.push_back(curve.*member);
  writeValues(group, name, ValueType::Float64, values);
}

std::vector<std::int64_t>
integers(const Handle& group, const char* name)
{
  return StoredColumn(group, name).all<std::int64_t>(H5T_NATIVE_INT64);
}

/** \brief The same for one value per line, of \a count lines. */
std::vector<std::int64_t>
integers(const Handle& group, const char* name, std::size_t count)
{
  auto values = integers(group, name);
  if (values.size() != count)
    throw Error(std::string("its lines have ") + std::to_string(values.size()) +
                " values of " + name + " for " + std::to_string(count) + " lines");
  return values;
}

void
readNumbers(const Handle& group,
            const char* name,
            std::vector<Curve>& curves,
            double Curve::*member)
{
  if (!exists(group, name))
    return;
  const auto values = StoredColumn(group, name).all<double>(H5T_NATIVE_DOUBLE);
  for (std::size_t i = 0; i < std::min(values.size(), curves.size()); ++i)
    curves[i].*member = values[i];
}

/** \brief Whether \a count values from \a first on are among \a size. */
bool
isWithin(std::int64_t first, std::int64_t count, std::size_t size)
{
  return first >= 0 && count >= 0 && static_cast<std::uint64_t>(first) <= size &&
         static_cast<std::uint64_t>(count) <= size - static_cast<std::uint64_t>(first);
}

CurveEnd
endOf(std::int64_t kind, std::int64_t junction, std::size_t junctions)
{
  CurveEnd end;
  if (kind >= 0 && kind <= static_cast<std::int64_t>(EndKind::Loop))
    end.kind = static_cast<EndKind>(kind);
  if (junction >= 0 && static_cast<std::uint64_t>(junction) < junctions)
    end.junction = static_cast<int>(junction);
  return end;
}

void
writeJunctions(const Handle& file, const CurveNetwork& network, const Point& shift)
{
  if (network.junctions.empty())
    return;
  Points places;
  std::vector<std::int64_t> first = {0}, members;
  for (const Junction& junction : network.junctions) {
    places.push_back(junction.position);
    for (const std::size_t curve : junction.curves)
      members.push_back(static_cast<std::int64_t>(curve));
    first.push_back(static_cast<std::int64_t>(members.size()));
  }
  const Handle group = pointsGroup(file, junctions_group, places, shift, {});
  writeValues(group, "first", ValueType::Int64, first);
  writeValues(group, "curves", ValueType::Int64, members);
}

void
readJunctions(const Handle& file, CurveNetwork& network)
{
  if (!exists(file, curves_grid) || !exists(file, junctions_group))
    return;
  const Handle group = openGroup(file, junctions_group);
  const Points places = pointsOf(group);
  const auto first = integers(group, "first", places.size() + 1);
  const auto members = integers(group, "curves");
  for (std::size_t j = 0; j < places.size(); ++j) {
    Junction junction;
    junction.position = places[j];
    if (!isWithin(first[j], first[j + 1] - first[j], members.size()))
      throw Error("its junctions name curves that are not there");
    for (std::int64_t k = first[j]; k < first[j + 1]; ++k) {
      const std::int64_t curve = members[static_cast<std::size_t>(k)];
      if (curve < 0 || static_cast<std::uint64_t>(curve) >= network.curves.size())
        throw Error("its junctions name curves that are not there");
      junction.curves.push_back(static_cast<std::size_t>(curve));
    }
    network.junctions.push_back(std::move(junction));
  }
}

} // namespace

void
writeCurveGrid(const Handle& file,
               const CurveNetwork& network,
               const Point& shift,
               const std::string& wkt)
{
  Points vertices;
  std::vector<std::int64_t> first, edges, support;
  bool supported = true;
  for (const Curve& curve : network.curves) {
    first.push_back(static_cast<std::int64_t>(vertices.size()));
    const auto begin = static_cast<std::int64_t>(vertices.size());
    vertices.insert(vertices.end(), curve.points.begin(), curve.points.end());
    for (auto v = begin; v + 1 < static_cast<std::int64_t>(vertices.size()); ++v)
      edges.insert(edges.end(), {v, v + 1});
    if (curve.closed && !curve.points.empty())
      edges.insert(edges.end(),
                   {static_cast<std::int64_t>(vertices.size()) - 1, begin});
    supported = supported && curve.support.size() == curve.points.size();
    support.insert(support.end(), curve.support.begin(), curve.support.end());
  }
  const Handle points = pointsGroup(file, chartOf(curves_grid), vertices, shift, wkt);
  if (supported && !vertices.empty())
    writeValues(points, "support", ValueType::Int64, support);

  const std::vector<Curve>& curves = network.curves;
  const Handle lines = createGroup(file, lines_group);
  writeValues(lines, "first", ValueType::Int64, first);
  writeIntegers(lines, "count", curves, [](const Curve& c) { return c.points.size(); });
  writeIntegers(lines, "closed", curves, [](const Curve& c) { return c.closed; });
  writeIntegers(
      lines, "front", curves, [](const Curve& c) { return int(c.front.kind); });
  writeIntegers(lines, "back", curves, [](const Curve& c) { return int(c.back.kind); });
  writeIntegers(
      lines, "front_junction", curves, [](const Curve& c) { return c.front.junction; });
  writeIntegers(
      lines, "back_junction", curves, [](const Curve& c) { return c.back.junction; });
  writeNumbers(lines, "noise", curves, &Curve::noise);
  writeNumbers(lines, "density", curves, &Curve::density);
  writeNumbers(lines, "evidence", curves, &Curve::evidence);
  std::string kinds;
  for (const auto& entry : Names<EndKind>::table)
    kinds += (kinds.empty() ? "" : " ") + std::string(entry.second);
  setAttribute(lines, "end_kinds", kinds);
  const std::vector<Member> ends = {{"from", ValueType::Int64},
                                    {"to", ValueType::Int64}};
  Column1D(
      lines, "Edges", compoundType(ends, true).id(), compoundType(ends, false).id())
      .append(edges.data(), edges.size() / 2);
  writeJunctions(file, network, shift);
}

CurveNetwork
readCurveGrid(const Handle& file, std::string* wkt)
{
  if (!exists(file, time_slice) || !exists(file, curves_grid) ||
      !exists(file, lines_group))
    throw Error("cannot find a grid of curves in it");
  const Handle points = openGroup(file, chartOf(curves_grid));
  const Points vertices = pointsOf(points);
  if (wkt != nullptr)
    *wkt = textAttribute(points, "wkt");
  std::vector<std::int64_t> support;
  if (exists(points, "support"))
    support = integers(points, "support", vertices.size());

  const Handle lines = openGroup(file, lines_group);
  const auto first = integers(lines, "first");
  const std::size_t number = first.size();
  const auto count = integers(lines, "count", number);
  const auto closed = integers(lines, "closed", number);
  const auto front = integers(lines, "front", number);
  const auto back = integers(lines, "back", number);
  const auto front_junction = integers(lines, "front_junction", number);
  const auto back_junction = integers(lines, "back_junction", number);
  CurveNetwork network;
  std::size_t all = 0;
  for (std::size_t i = 0; i < number; ++i) {
    if (!isWithin(first[i], count[i], vertices.size()) ||
        (all += static_cast<std::size_t>(count[i])) > vertices.size())
      throw Error("its lines name vertices that do not exist");
    Curve curve;
    const auto begin = vertices.begin() + first[i];
    curve.points.assign(begin, begin + count[i]);
    if (!support.empty())
      for (std::int64_t k = first[i]; k < first[i] + count[i]; ++k)
        curve.support.push_back(
            static_cast<Index>(support[static_cast<std::size_t>(k)]));
    curve.closed = closed[i] != 0;
    network.curves.push_back(std::move(curve));
  }
  readNumbers(lines, "noise", network.curves, &Curve::noise);
  readNumbers(lines, "density", network.curves, &Curve::density);
  readNumbers(lines, "evidence", network.curves, &Curve::evidence);
  readJunctions(file, network);
  for (std::size_t i = 0; i < number; ++i) {
    network.curves[i].front =
        endOf(front[i], front_junction[i], network.junctions.size());
    network.curves[i].back = endOf(back[i], back_junction[i], network.junctions.size());
  }
  return network;
}

} // namespace linelet::io::hdf5
