// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtk_curves.h"

#include <utility>

#include "curve_lines.h"
#include "io/vector/curve_through.h"
#include "scanned_words.h"

namespace linelet::io {

CurveNetwork
curvesFromVtk(const Source& source)
{
  ScannedWords words(source);
  Points vertices;
  CurveNetwork network;
  if (source.bytes.substr(0, source.bytes.find("DATASET")).find("ASCII") ==
      std::string_view::npos)
    source.fail("is not an ASCII VTK file, the only kind from which curves are read");
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "POINTS") {
      const auto count = words.number<std::size_t>("POINTS");
      words.next(); // their type
      for (std::size_t i = 0; i < count; ++i)
        vertices.push_back(words.point("POINTS"));
    }
    else if (word == "LINES") {
      const auto count = words.number<std::size_t>("LINES");
      words.next(); // number of values
      for (std::size_t i = 0; i < count; ++i) {
        Points line;
        for (auto left = words.number<std::size_t>("LINES"); left > 0; --left)
          line.push_back(vertices[placeOf(
              source, words.number<double>("LINES"), vertices.size())]);
        network.curves.push_back(curveThrough(std::move(line)));
      }
      return network;
    }
  }
  return network;
}

std::string
curvesAsVtk(const CurveNetwork& network, const Point& shift)
{
  const LineSizes sizes = sizesOf(network);
  const std::string lines = std::to_string(sizes.lines);
  std::string text = "# vtk DataFile Version 3.0\ncurves, written by linelet\nASCII\n"
                     "DATASET POLYDATA\nPOINTS " +
                     std::to_string(sizes.vertices) + " double\n";
  appendVertices(text, network, shift, "");
  text += "LINES " + lines + ' ' +
          std::to_string(sizes.lines + sizes.vertices + sizes.closed) + '\n';
  forEachLine(network, [&](const Curve& curve, std::size_t, std::size_t first) {
    text += std::to_string(curve.points.size() + (curve.closed ? 1 : 0));
    appendPlaces(text, curve, first);
  });
  const auto append = [&](const char* name, const char* type, auto value) {
    text += std::string(name) + " 1 " + lines + ' ' + type + '\n';
    forEachLine(network, [&](const Curve& curve, std::size_t id, std::size_t) {
      value(curve, id);
      text += '\n';
    });
  };
  text += "CELL_DATA " + lines + "\nFIELD attributes 8\n";
  append("curve", "int", [&](const Curve&, std::size_t id) { appendNumber(text, id); });
  append("closed", "int", [&](const Curve& curve, std::size_t) {
    text += curve.closed ? '1' : '0';
  });
  append("length", "double", [&](const Curve& curve, std::size_t) {
    appendNumber(text, length(curve));
  });
  append("front", "string", [&](const Curve& curve, std::size_t) {
    text += nameOf(curve.front.kind);
  });
  append("back", "string", [&](const Curve& curve, std::size_t) {
    text += nameOf(curve.back.kind);
  });
  append("noise", "double", [&](const Curve& curve, std::size_t) {
    appendNumber(text, curve.noise);
  });
  append("density", "double", [&](const Curve& curve, std::size_t) {
    appendNumber(text, curve.density);
  });
  append("evidence", "double", [&](const Curve& curve, std::size_t) {
    appendNumber(text, curve.evidence);
  });
  return text;
}

} // namespace linelet::io
