// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curve_lines.h"

#include "io/text_scan.h"

namespace linelet::io {

LineSizes
sizesOf(const CurveNetwork& network)
{
  LineSizes sizes;
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

void
appendPlaces(std::string& text, const Curve& curve, std::size_t first)
{
  for (std::size_t i = 0; i < curve.points.size() + (curve.closed ? 1 : 0); ++i)
    text += ' ' + std::to_string(first + i % curve.points.size());
  text += '\n';
}

} // namespace linelet::io
