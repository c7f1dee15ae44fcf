// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ply_curves.h"

#include <map>
#include <utility>
#include <vector>

#include "curve_lines.h"
#include "io/vector/curve_through.h"
#include "scanned_words.h"

namespace linelet::io {

namespace {

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<std::string> properties;
};

/** The elements of an ASCII PLY file; leaves \a words after end_header. */
std::vector<PlyElement>
plyElements(const Source& source, ScannedWords& words)
{
  if (words.next() != "ply" || words.next() != "format" || words.next() != "ascii")
    source.fail("is not an ASCII PLY file, the only kind from which curves are read");
  std::vector<PlyElement> elements;
  Lines lines(source.bytes);
  for (std::string_view line; lines.next(line);) {
    std::string_view rest = line;
    const std::string_view word = takeWord(rest);
    if (word == "element") {
      PlyElement element;
      element.name = takeWord(rest);
      if (!parseNumber(takeWord(rest), element.count))
        source.fail("its element '" + cleanName(element.name) + "' has no count");
      elements.push_back(std::move(element));
    }
    else if (word == "property" && !elements.empty()) {
      if (takeWord(rest) == "list")
        source.fail("has lists (faces?), which cannot be read as curves");
      elements.back().properties.emplace_back(takeWord(rest));
    }
    else if (word == "end_header") {
      while (words.next() != "end_header")
        ;
      return elements;
    }
  }
  source.fail("its header does not end");
}

/** Rows of the elements of a PLY file, as numbers by name. */
template <class Row>
void
forEachPlyRow(const Source& source, Row row)
{
  ScannedWords words(source);
  for (const PlyElement& element : plyElements(source, words)) {
    std::map<std::string, double> values;
    for (std::size_t i = 0; i < element.count; ++i) {
      for (const std::string& property : element.properties)
        values[property] = words.number<double>(element.name.c_str());
      row(element.name, values);
    }
  }
}

} // namespace

CurveNetwork
curvesFromPly(const Source& source)
{
  Points vertices;
  CurveNetwork network;
  Points line;
  std::size_t last = 0;
  double curve = -1;
  const auto finish = [&] {
    if (line.size() > 1)
      network.curves.push_back(curveThrough(std::move(line)));
    line.clear();
  };
  forEachPlyRow(source, [&](const std::string& element, auto& row) {
    if (element == "vertex")
      vertices.emplace_back(row["x"], row["y"], row["z"]);
    if (element != "edge")
      return;
    const std::size_t from = placeOf(source, row["vertex1"], vertices.size()),
                      to = placeOf(source, row["vertex2"], vertices.size());
    // Consecutive edges are one curve, unless a property separates them.
    if (line.empty() || from != last || row["curve"] != curve) {
      finish();
      line.push_back(vertices[from]);
    }
    line.push_back(vertices[to]);
    last = to;
    curve = row["curve"];
  });
  finish();
  return network;
}

std::string
curvesAsPly(const CurveNetwork& network, const Point& shift)
{
  const LineSizes sizes = sizesOf(network);
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
          "property uchar front\nproperty uchar back\nproperty double noise\n"
          "property double density\nproperty double evidence\nend_header\n";
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
            std::to_string(static_cast<int>(curve.back.kind));
    for (const double value : {curve.noise, curve.density, curve.evidence}) {
      text += ' ';
      appendNumber(text, value);
    }
    text += '\n';
  });
  return text;
}

} // namespace linelet::io
