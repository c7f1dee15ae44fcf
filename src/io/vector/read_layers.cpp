// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "complaints.h"
#include "curve_readers.h"
#include "io/files.h"

namespace linelet::io {

namespace {

void
addLine(const OGRLineString& line, CurveNetwork& network)
{
  Points vertices;
  for (int i = 0; i < line.getNumPoints(); ++i)
    vertices.emplace_back(line.getX(i), line.getY(i), line.getZ(i));
  if (vertices.size() > 1)
    network.curves.push_back(curveThrough(std::move(vertices)));
}

void
addLines(const OGRGeometry* geometry, CurveNetwork& network)
{
  if (geometry == nullptr)
    return;
  if (const auto type = wkbFlatten(geometry->getGeometryType()); type == wkbLineString)
    addLine(*geometry->toLineString(), network);
  else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0)
    for (const OGRGeometry* part : *geometry->toGeometryCollection())
      addLines(part, network);
}

std::string
referenceOf(OGRLayer& layer)
{
  // GDAL takes GeoJSON that tells no system for degrees, and linelet's local systems
  // for systems.
  const OGRSpatialReference* system = layer.GetSpatialRef();
  char* text = nullptr;
  std::string wkt;
  if (system != nullptr && system->IsLocal() == 0 &&
      system->exportToWkt(&text) == OGRERR_NONE)
    wkt = text;
  CPLFree(text);
  return wkt;
}

} // namespace

CurveNetwork
curvesFromLayers(const Source& source, std::string* wkt)
{
  GDALAllRegister();
  const Complaints complaints;
  const char* const drivers[] = {"GeoJSON", "GPKG", "DXF", nullptr};
  const std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(
      source.name.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers));
  if (dataset == nullptr)
    source.fail("cannot be read as what its ending says (" + complaints.first() +
                "); check that it is whole");
  CurveNetwork network;
  const bool tells = endingOf(source.name) != ".geojson" ||
                     source.bytes.substr(0, 1000).find("\"crs\"") != std::string::npos;
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
