// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curve_writers.h"

#include "io/text/text_scan.h"

namespace linelet::io {

namespace {

/** Calls f(curve, number, place of its first vertex) for every curve that is a line. */
template <class F>
void
forEachLine(const CurveNetwork& network, F f)
{
  std::size_t first = 0;
  for (std::size_t i = 0; i < network.curves.size(); ++i) {
    const Curve& curve = network.curves[i];
    if (curve.points.size() < 2)
      continue;
    f(curve, i, first);
    first += curve.points.size();
  }
}

struct Sizes {
  std::size_t vertices = 0, lines = 0, edges = 0, closed = 0;
};

Sizes
sizesOf(const CurveNetwork& network)
{
  Sizes sizes;
  forEachLine(network, [&](const Curve& curve, std::size_t, std::size_t) {
    sizes.vertices += curve.points.size();
    sizes.edges += curve.points.size() - (curve.closed ? 0 : 1);
    sizes.closed += curve.closed ? 1 : 0;
    ++sizes.lines;
  });
  return sizes;
}

void
appendVertices(std::string& text,
               const CurveNetwork& network,
               const Point& shift,
               const char* lead)
{
  forEachLine(network, [&](const Curve& curve, std::size_t, std::size_t) {
    for (const Point& point : curve.points) {
      text += lead;
      appendPoint(text, shift + point);
      text += '\n';
    }
  });
}

/** Appends " i" for each vertex of a curve, the first once more where it is closed. */
void
appendPlaces(std::string& text, const Curve& curve, std::size_t first)
{
  for (std::size_t i = 0; i < curve.points.size() + (curve.closed ? 1 : 0); ++i)
    text += ' ' + std::to_string(first + i % curve.points.size());
  text += '\n';
}

} // namespace

std::string
curvesAsObj(const CurveNetwork& network, const Point& shift)
{
  std::string text = "# curves, written by linelet\n";
  appendVertices(text, network, shift, "v ");
  forEachLine(network, [&](const Curve& curve, std::size_t, std::size_t first) {
    text += 'l';
    appendPlaces(text, curve, first + 1);
  });
  return text;
}

std::string
curvesAsPly(const CurveNetwork& network, const Point& shift)
{
  const Sizes sizes = sizesOf(network);
  std::string text = "ply\nformat ascii 1.0\ncomment curves, written by linelet\n"
                     "comment ends of a curve:";
  for (const auto& entry : Names<EndKind>::table) {
    text += ' ' + std::to_string(static_cast<int>(entry.first)) + '=';
    text += entry.second;
  }
  text += "\nelement vertex " + std::to_string(sizes.vertices) +
          "\nproperty double x\nproperty double y\nproperty double z\nelement edge " +
          std::to_string(sizes.edges) +
          "\nproperty int vertex1\nproperty int vertex2\nproperty int curve\n"
          "element curve " +
          std::to_string(sizes.lines) +
          "\nproperty int curve\nproperty uchar closed\nproperty double length\n"
          "property uchar front\nproperty uchar back\nend_header\n";
  appendVertices(text, network, shift, "");
  forEachLine(network, [&](const Curve& curve, std::size_t id, std::size_t first) {
    const std::size_t count = curve.points.size();
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i)
      text += std::to_string(first + i) + ' ' +
              std::to_string(first + (i + 1) % count) + ' ' + std::to_string(id) + '\n';
  });
  forEachLine(network, [&](const Curve& curve, std::size_t id, std::size_t) {
    text += std::to_string(id) + (curve.closed ? " 1 " : " 0 ");
    appendNumber(text, length(curve));
    text += ' ' + std::to_string(static_cast<int>(curve.front.kind)) + ' ' +
            std::to_string(static_cast<int>(curve.back.kind)) + '\n';
  });
  return text;
}

std::string
curvesAsVtk(const CurveNetwork& network, const Point& shift)
{
  const Sizes sizes = sizesOf(network);
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
  text += "CELL_DATA " + lines + "\nFIELD attributes 5\n";
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
  return text;
}

std::string
curvesAsCsv(const CurveNetwork& network, const Point& shift)
{
  std::string text = "curve,vertex,x,y,z,closed,length,front,back\n";
  forEachLine(network, [&](const Curve& curve, std::size_t id, std::size_t) {
    std::string tail = curve.closed ? ",1," : ",0,";
    appendNumber(tail, length(curve));
    for (EndKind kind : {curve.front.kind, curve.back.kind}) {
      tail += ',';
      tail += nameOf(kind);
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
