// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "geojson.h"

#include <cmath>

#include <ogr_spatialref.h>

#include "io/text_scan.h"
#include "reference.h"

namespace linelet::io {

namespace {

void
appendText(std::string& json, std::string_view text)
{
  json += '"';
  for (char letter : text) {
    if (letter == '"' || letter == '\\')
      json += '\\';
    if (static_cast<unsigned char>(letter) >= 0x20) {
      json += letter;
      continue;
    }
    constexpr char digits[] = "0123456789abcdef";
    json += "\\u00";
    json += digits[letter >> 4];
    json += digits[letter & 15];
  }
  json += '"';
}

void
appendReal(std::string& json, double value)
{
  if (std::isfinite(value))
    appendNumber(json, value);
  else
    json += "null"; // JSON has no NaN
}

std::string
urnPart(const OGRSpatialReference& system, const char* part)
{
  const char* authority = system.GetAuthorityName(part);
  const char* code = system.GetAuthorityCode(part);
  if (authority == nullptr || code == nullptr)
    return {};
  return std::string("crs:") + authority + "::" + code;
}

/** The name that GDAL, and hence QGIS, understands; "" for an unknown system. */
std::string
systemName(const std::string& wkt)
{
  const Reference system = parseReference(wkt);
  if (system == nullptr)
    return {};
  const std::string whole = urnPart(*system, nullptr);
  if (!whole.empty())
    return "urn:ogc:def:" + whole;
  if (system->IsCompound() != 0) {
    const std::string plane =
        urnPart(*system, system->IsProjected() != 0 ? "PROJCS" : "GEOGCS");
    const std::string height = urnPart(*system, "VERT_CS");
    if (!plane.empty() && !height.empty())
      return "urn:ogc:def:crs," + plane + "," + height;
  }
  return wkt;
}

void
appendGeometry(std::string& json, VectorLayer::Kind kind, const Points& vertices)
{
  const bool point = kind == VectorLayer::Kind::Points,
             ring = kind == VectorLayer::Kind::Polygons;
  json += point  ? R"({"type":"Point","coordinates":)"
          : ring ? R"({"type":"Polygon","coordinates":[[)"
                 : R"({"type":"LineString","coordinates":[)";
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    json += i == 0 ? "[" : ",[";
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0)
        json += ',';
      appendReal(json, vertices[i][axis]);
    }
    json += ']';
  }
  json += point ? "}" : ring ? "]]}" : "]}";
}

void
appendFeature(std::string& json, const VectorLayer& layer, const VectorFeature& feature)
{
  json += R"({"type":"Feature","properties":{"layer":)";
  appendText(json, layer.name);
  for (const auto& [name, value] : feature.attributes) {
    json += ',';
    appendText(json, name);
    json += ':';
    if (const auto* number = std::get_if<std::int64_t>(&value))
      appendNumber(json, *number);
    else if (const auto* real = std::get_if<double>(&value))
      appendReal(json, *real);
    else
      appendText(json, std::get<std::string>(value));
  }
  json += R"(},"geometry":)";
  appendGeometry(json, layer.kind, feature.vertices);
  json += '}';
}

} // namespace

std::string
layersAsGeoJson(const std::vector<VectorLayer>& layers,
                const std::string& wkt,
                const ProgressMonitor* monitor)
{
  std::string json = "{\n\"type\":\"FeatureCollection\",\n";
  const std::string name = systemName(wkt);
  if (name.empty())
    json += "\"crs\":null,\n";
  else {
    json += R"("crs":{"type":"name","properties":{"name":)";
    appendText(json, name);
    json += "}},\n";
  }
  json += "\"features\":[";
  bool first = true;
  for (const VectorLayer& layer : layers)
    for (const VectorFeature& feature : layer.features) {
      throwIfCanceled(monitor);
      json += first ? "\n" : ",\n";
      appendFeature(json, layer, feature);
      first = false;
    }
  json += "\n]\n}\n";
  return json;
}

} // namespace linelet::io
