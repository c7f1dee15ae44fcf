// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "csv_curves.h"

#include <array>
#include <cmath>
#include <map>

#include "curve_lines.h"
#include "io/text_scan.h"

namespace linelet::io {

CurveNetwork
curvesFromCsv(const Source& source)
{
  Lines lines(source.bytes);
  std::string_view line;
  lines.next(line);
  const auto takeCell = [](std::string_view& rest) {
    const std::string_view cell = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), cell.size() + 1));
    return cell;
  };
  std::array<std::size_t, 5> places{}; // in a row, from 1
  constexpr std::array<std::string_view, 5> names = {"curve", "x", "y", "z", "closed"};
  for (std::size_t place = 1; !line.empty(); ++place) {
    const std::string_view name = takeCell(line);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (name == names[i])
        places[i] = place;
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (places[i] == 0)
      source.fail("its first line names no column '" + std::string(names[i]) +
                  "'; curves have curve, x, y and z");
  CurveNetwork network;
  std::map<std::string, std::size_t, std::less<>> curves;
  while (lines.next(line)) {
    if (line.empty())
      continue;
    std::array<std::string_view, 5> cells;
    for (std::size_t place = 1; !line.empty(); ++place) {
      const std::string_view cell = takeCell(line);
      for (std::size_t i = 0; i < cells.size(); ++i)
        if (places[i] == place)
          cells[i] = cell;
    }
    Point p;
    for (int axis = 0; axis < 3; ++axis)
      if (!parseNumber(cells[static_cast<std::size_t>(axis) + 1], p[axis]))
        source.fail("line " + std::to_string(lines.number()) +
                    ": a vertex needs three numbers");
    const auto [found, fresh] =
        curves.emplace(std::string(cells[0]), network.curves.size());
    if (fresh) {
      network.curves.emplace_back();
      Curve& curve = network.curves.back();
      curve.closed = cells[4] == "1";
      if (curve.closed)
        curve.front.kind = curve.back.kind = EndKind::Loop;
    }
    network.curves[found->second].points.push_back(p);
  }
  return network;
}

std::string
curvesAsCsv(const CurveNetwork& network, const Point& shift)
{
  std::string text =
      "curve,vertex,x,y,z,closed,length,front,back,noise,density,evidence\n";
  forEachLine(network, [&](const Curve& curve, std::size_t id, std::size_t) {
    std::string tail = curve.closed ? ",1," : ",0,";
    appendNumber(tail, length(curve));
    for (EndKind kind : {curve.front.kind, curve.back.kind}) {
      tail += ',';
      tail += nameOf(kind);
    }
    for (const double value : {curve.noise, curve.density, curve.evidence}) {
      tail += ',';
      if (std::isfinite(value))
        appendNumber(tail, value);
    }
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      text += std::to_string(id) + ',' + std::to_string(i) + ',';
      appendPoint(text, shift + curve.points[i], ',');
      text += tail + '\n';
    }
  });
  return text;
}

} // namespace linelet::io
