// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "layer_reader.h"

#include <utility>

#include <linelet/io/vector_file.h>

#include "curve_through.h"
#include "geometry_walk.h"
#include "io/files.h"

namespace linelet::io {

namespace {

/** Collects lines. */
struct LinesInto {
  void
  operator()(const OGRPoint&) const
  {
  }

  void
  operator()(const OGRLineString& line) const
  {
    Points vertices;
    for (int i = 0; i < line.getNumPoints(); ++i)
      vertices.emplace_back(line.getX(i), line.getY(i), line.getZ(i));
    if (vertices.size() > 1)
      network.curves.push_back(curveThrough(std::move(vertices)));
  }

  CurveNetwork& network;
};

void
addLines(const OGRGeometry* geometry, CurveNetwork& network)
{
  LinesInto lines{network};
  forEachPart(geometry, lines);
}

Value
valueOf(const OGRFeature& feature, int field)
{
  switch (feature.GetFieldDefnRef(field)->GetType()) {
  case OFTInteger:
  case OFTInteger64:
    return static_cast<std::int64_t>(feature.GetFieldAsInteger64(field));
  case OFTReal:
    return feature.GetFieldAsDouble(field);
  default:
    return std::string(feature.GetFieldAsString(field));
  }
}

VectorLayer
layerFrom(OGRLayer& layer)
{
  VectorLayer result;
  result.name = layer.GetName();
  for (const OGRFeatureUniquePtr& feature : layer) {
    CurveNetwork lines;
    addLines(feature->GetGeometryRef(), lines);
    for (Curve& line : lines.curves) {
      VectorFeature read;
      read.vertices = std::move(line.points);
      if (line.closed)
        read.vertices.push_back(read.vertices.front());
      for (int i = 0; i < feature->GetFieldCount(); ++i)
        read.attributes.emplace_back(feature->GetFieldDefnRef(i)->GetNameRef(),
                                     valueOf(*feature, i));
      result.features.push_back(std::move(read));
    }
  }
  return result;
}

} // namespace

std::vector<VectorLayer>
readLayers(const std::string& path)
{
  const Complaints complaints;
  const auto dataset = openDataset(path, complaints);
  std::vector<VectorLayer> layers;
  for (OGRLayer* layer : dataset->GetLayers())
    if (VectorLayer read = layerFrom(*layer); !read.features.empty())
      layers.push_back(std::move(read));
  return layers;
}

CurveNetwork
curvesFromLayers(const Source& source, std::string* wkt)
{
  const Complaints complaints;
  const auto dataset = openDataset(source.name, complaints);
  CurveNetwork network;
  // A null CRS means unknown; without the member it is WGS 84.
  const bool tells =
      endingOf(source.name) != ".geojson" ||
      source.bytes.substr(0, 1000).find("\"crs\":null") == std::string::npos;
  for (OGRLayer* layer : dataset->GetLayers()) {
    if (wkt != nullptr && wkt->empty() && tells)
      *wkt = referenceOf(*layer);
    for (const OGRFeatureUniquePtr& feature : *layer)
      addLines(feature->GetGeometryRef(), network);
  }
  if (!complaints.first().empty() && network.curves.empty())
    source.fail("cannot be read (" + complaints.first() + ")");
  return network;
}

} // namespace linelet::io
