// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "layer_csv.h"

#include <cmath>

#include "io/text_scan.h"

namespace linelet::io {

namespace {

void
appendText(std::string& csv, const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    csv += text;
    return;
  }
  csv += '"';
  for (const char letter : text) {
    if (letter == '"')
      csv += '"';
    csv += letter;
  }
  csv += '"';
}

void
appendValue(std::string& csv, const Value& value)
{
  if (const auto* number = std::get_if<std::int64_t>(&value))
    appendNumber(csv, *number);
  else if (const auto* real = std::get_if<double>(&value)) {
    if (std::isfinite(*real))
      appendNumber(csv, *real);
  }
  else
    appendText(csv, std::get<std::string>(value));
}

std::string
wellKnownText(VectorLayer::Kind kind, const Points& vertices)
{
  const bool ring = kind == VectorLayer::Kind::Polygons;
  std::string text = kind == VectorLayer::Kind::Points ? "POINT Z ("
                     : ring                            ? "POLYGON Z (("
                                                       : "LINESTRING Z (";
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    text += i == 0 ? "" : ",";
    for (int axis = 0; axis < 3; ++axis) {
      text += axis == 0 ? "" : " ";
      appendNumber(text, vertices[i][axis]);
    }
  }
  return text + (ring ? "))" : ")");
}

} // namespace

std::string
layerAsCsv(const VectorLayer& layer)
{
  const Attributes& columns =
      layer.features.empty() ? layer.columns : layer.features.front().attributes;
  std::string csv;
  for (const auto& [name, value] : columns) {
    appendText(csv, name);
    csv += ',';
  }
  csv += "WKT\n";
  for (const VectorFeature& feature : layer.features) {
    for (const auto& [name, value] : feature.attributes) {
      appendValue(csv, value);
      csv += ',';
    }
    appendText(csv, wellKnownText(layer.kind, feature.vertices));
    csv += '\n';
  }
  return csv;
}

} // namespace linelet::io
