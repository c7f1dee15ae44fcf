// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>

#include <linelet/curves/curve_network.h>

namespace linelet::io {

/** \brief Calls f(curve, number, index of its first vertex) for every curve with at
 * least two vertices. */
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

/** \brief Numbers of the elements to write. */
struct LineSizes {
  std::size_t vertices = 0, lines = 0, edges = 0, closed = 0;
};

LineSizes
sizesOf(const CurveNetwork& network);

/** \brief Appends a line of text per vertex that begins with \a lead. */
void
appendVertices(std::string& text,
               const CurveNetwork& network,
               const Point& shift,
               const char* lead);

/** \brief Appends " i" for each vertex of \a curve, and the first again if it is
 * closed. */
void
appendPlaces(std::string& text, const Curve& curve, std::size_t first);

} // namespace linelet::io
