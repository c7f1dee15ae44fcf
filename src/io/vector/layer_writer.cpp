// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "layer_writer.h"

#include <cmath>

#include <linelet/io/file_error.h>

namespace linelet::io {

LayerWriter::LayerWriter(const std::string& path,
                         const std::string& staged,
                         const char* driver_name)
    : path_(path)
{
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name);
  if (driver == nullptr)
    throw FileError(path + ": this GDAL was built without its " + driver_name +
                    " driver");
  dataset_.reset(driver->Create(staged.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (dataset_ == nullptr)
    fail();
}

OGRLayer*
LayerWriter::makeLayer(const std::string& name,
                       OGRwkbGeometryType type,
                       OGRSpatialReference* system,
                       const char* const* options)
{
  OGRLayer* layer = dataset_->CreateLayer(
      name.c_str(), system, type, const_cast<char**>(options)); // only read
  if (layer == nullptr)
    fail();
  return layer;
}

void
LayerWriter::makeField(OGRLayer& layer, const std::string& name, OGRFieldType type)
{
  OGRFieldDefn field(name.c_str(), type);
  if (layer.CreateField(&field) != OGRERR_NONE)
    fail();
}

void
LayerWriter::makeFields(OGRLayer& layer, const VectorLayer& content)
{
  const Attributes& columns =
      content.features.empty() ? content.columns : content.features.front().attributes;
  for (const auto& [name, value] : columns) {
    static constexpr OGRFieldType types[] = {OFTInteger64, OFTReal, OFTString};
    if (layer.GetLayerDefn()->GetFieldIndex(name.c_str()) < 0)
      makeField(layer, name, types[value.index()]);
  }
}

OGRFeatureUniquePtr
LayerWriter::makeFeature(OGRLayer& layer,
                         VectorLayer::Kind kind,
                         const Points& vertices)
{
  OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer.GetLayerDefn()));
  if (kind == VectorLayer::Kind::Points) {
    if (vertices.size() != 1)
      throw FileError(path_ + ": a point of layer '" + layer.GetName() + "' has " +
                      std::to_string(vertices.size()) + " vertices");
    const Point& at = vertices.front();
    feature->SetGeometryDirectly(new OGRPoint(at.x(), at.y(), at.z()));
    return feature;
  }
  const bool ring = kind == VectorLayer::Kind::Polygons;
  std::unique_ptr<OGRLineString> line(ring ? new OGRLinearRing : new OGRLineString);
  for (const Point& at : vertices)
    line->addPoint(at.x(), at.y(), at.z());
  if (ring) {
    auto polygon = std::make_unique<OGRPolygon>();
    polygon->addRingDirectly(static_cast<OGRLinearRing*>(line.release()));
    feature->SetGeometryDirectly(polygon.release());
  }
  else
    feature->SetGeometryDirectly(line.release());
  return feature;
}

void
LayerWriter::setAttributes(OGRFeature& out, const VectorFeature& feature)
{
  for (const auto& [name, value] : feature.attributes) {
    const int field = out.GetFieldIndex(name.c_str());
    if (const auto* number = std::get_if<std::int64_t>(&value))
      out.SetField(field, static_cast<GIntBig>(*number));
    else if (const auto* real = std::get_if<double>(&value))
      out.SetField(field, *real);
    else
      out.SetField(field, std::get<std::string>(value).c_str());
  }
}

void
LayerWriter::add(OGRLayer& layer, OGRFeature& feature)
{
  if (layer.CreateFeature(&feature) != OGRERR_NONE)
    fail();
}

void
LayerWriter::close()
{
  dataset_->FlushCache(true);
  const bool failed = CPLGetLastErrorType() >= CE_Failure;
  dataset_.reset();
  if (failed || CPLGetLastErrorType() >= CE_Failure)
    fail();
}

void
LayerWriter::fail() const
{
  const std::string& reason = complaints_.first();
  throw FileError(path_ + ": cannot be written (" +
                  (reason.empty() ? "GDAL gives no reason" : reason) +
                  "); check that the folder exists, is writable and has free space");
}

} // namespace linelet::io
