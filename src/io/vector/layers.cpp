// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/vector_file.h>

#include <algorithm>
#include <memory>

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <linelet/io/file_error.h>

#include "complaints.h"
#include "geojson.h"
#include "io/files.h"
#include "io/staged_file.h"
#include "layer_csv.h"
#include "reference.h"

namespace linelet::io {

namespace {

/** Sets a configuration option of GDAL for its lifetime. */
class GdalOption {
public:
  GdalOption(const char* name, const char* value) : name_(name)
  {
    CPLSetThreadLocalConfigOption(name_, value);
  }
  ~GdalOption() { CPLSetThreadLocalConfigOption(name_, nullptr); }
  GdalOption(const GdalOption&) = delete;
  GdalOption&
  operator=(const GdalOption&) = delete;

private:
  const char* name_;
};

/** Makes layers in a dataset of one driver. */
class LayerWriter {
public:
  LayerWriter(const std::string& path,
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
  makeLayer(const std::string& name,
            OGRwkbGeometryType type,
            OGRSpatialReference* system)
  {
    OGRLayer* layer = dataset_->CreateLayer(name.c_str(), system, type, nullptr);
    if (layer == nullptr)
      fail();
    return layer;
  }

  void
  makeFields(OGRLayer& layer, const VectorLayer& content)
  {
    const Attributes& columns = content.features.empty()
                                    ? content.columns
                                    : content.features.front().attributes;
    for (const auto& [name, value] : columns) {
      static constexpr OGRFieldType types[] = {OFTInteger64, OFTReal, OFTString};
      OGRFieldDefn field(name.c_str(), types[value.index()]);
      if (layer.CreateField(&field) != OGRERR_NONE)
        fail();
    }
  }

  OGRFeatureUniquePtr
  makeFeature(OGRLayer& layer, VectorLayer::Kind kind, const Points& vertices)
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

  static void
  setAttributes(OGRFeature& out, const VectorFeature& feature)
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
  add(OGRLayer& layer, OGRFeature& feature)
  {
    if (layer.CreateFeature(&feature) != OGRERR_NONE)
      fail();
  }

  /** Flushes everything; errors of the disk show here at the latest. */
  void
  close()
  {
    dataset_->FlushCache(true);
    const bool failed = CPLGetLastErrorType() >= CE_Failure;
    dataset_.reset();
    if (failed || CPLGetLastErrorType() >= CE_Failure)
      fail();
  }

private:
  [[noreturn]] void
  fail() const
  {
    const std::string& reason = complaints_.first();
    throw FileError(path_ + ": cannot be written (" +
                    (reason.empty() ? "GDAL gives no reason" : reason) +
                    "); check that the folder exists, may be written and has room");
  }

  const std::string& path_;
  Complaints complaints_;
  std::unique_ptr<GDALDataset> dataset_;
};

/** What GeoPackage calls a plane of which nothing is known. Without a system GDAL takes
 * coordinates for degrees. */
Reference
unknownPlane()
{
  Reference plane(new OGRSpatialReference);
  plane->SetLocalCS("Undefined Cartesian SRS");
  return plane;
}

void
writeGeoPackage(const std::string& path,
                const std::string& staged,
                const std::vector<VectorLayer>& layers,
                const std::string& wkt,
                const ProgressMonitor* monitor)
{
  // The same input gives the same bytes: no time of writing.
  const GdalOption date("OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z");
  Reference system = parseReference(wkt);
  if (system == nullptr)
    system = unknownPlane();
  CPLErrorReset();
  LayerWriter writer(path, staged, "GPKG");
  for (const VectorLayer& content : layers) {
    static constexpr OGRwkbGeometryType types[] = {
        wkbPoint25D, wkbLineString25D, wkbPolygon25D};
    OGRLayer* layer = writer.makeLayer(
        content.name, types[static_cast<std::size_t>(content.kind)], system.get());
    writer.makeFields(*layer, content);
    for (const VectorFeature& feature : content.features) {
      const auto out = writer.makeFeature(*layer, content.kind, feature.vertices);
      writer.setAttributes(*out, feature);
      writer.add(*layer, *out);
      throwIfCanceled(monitor);
    }
  }
  writer.close();
}

/** Text of a style string: quotes and backslashes escaped. */
std::string
labelStyle(const std::string& text, double height)
{
  std::string escaped;
  for (const char letter : text) {
    if (letter == '"' || letter == '\\')
      escaped += '\\';
    escaped += letter;
  }
  return "LABEL(f:\"Arial\",t:\"" + escaped + "\",s:" + std::to_string(height) +
         "g,p:5)";
}

/** DXF knows no attributes, but layers and texts. */
void
writeDxf(const std::string& path,
         const std::string& staged,
         const std::vector<VectorLayer>& layers,
         const ProgressMonitor* monitor)
{
  CPLErrorReset();
  LayerWriter writer(path, staged, "DXF");
  OGRLayer* layer = writer.makeLayer("entities", wkbUnknown, nullptr);
  for (const VectorLayer& content : layers)
    for (const VectorFeature& feature : content.features) {
      throwIfCanceled(monitor);
      const auto kind = content.kind == VectorLayer::Kind::Polygons
                            ? VectorLayer::Kind::Lines
                            : content.kind;
      const auto out = writer.makeFeature(*layer, kind, feature.vertices);
      const std::string& own = feature.drawing_layer;
      out->SetField("Layer", own.empty() ? content.name.c_str() : own.c_str());
      writer.add(*layer, *out);
      if (feature.label.empty())
        continue;
      const Point& middle = feature.vertices[feature.vertices.size() / 2];
      const auto text = writer.makeFeature(*layer, VectorLayer::Kind::Points, {middle});
      text->SetField("Layer", "labels");
      text->SetStyleString(labelStyle(feature.label, content.text_height).c_str());
      writer.add(*layer, *text);
    }
  writer.close();
}

bool
isEmpty(const std::vector<VectorLayer>& layers)
{
  return std::all_of(layers.begin(), layers.end(), [](const VectorLayer& layer) {
    return layer.features.empty();
  });
}

} // namespace

void
writeLayers(const std::string& path,
            const std::vector<VectorLayer>& layers,
            const std::string& wkt,
            std::vector<std::string>* warnings,
            ProgressMonitor* monitor)
{
  throwIfCanceled(monitor);
  const std::string ending = endingOf(path);
  if (ending == ".geojson") {
    if (wkt.empty() && warnings != nullptr && !isEmpty(layers))
      warnings->push_back(path + ": the input tells no reference system, so readers of "
                                 "GeoJSON take the coordinates for degrees; .gpkg says "
                                 "it is unknown");
    OutputFile file(path);
    file.write(layersAsGeoJson(layers, wkt, monitor));
    return file.commit();
  }
  if (ending == ".csv") {
    if (layers.size() != 1)
      throw FileError(path + ": a .csv holds one layer, not " +
                      std::to_string(layers.size()) + "; use .geojson, .gpkg or .dxf");
    OutputFile file(path);
    file.write(layerAsCsv(layers.front()));
    return file.commit();
  }
  if (ending != ".gpkg" && ending != ".dxf")
    throw FileError(path + ": the ending '" + ending +
                    "' names no vector format; use .geojson, .gpkg, .dxf or .csv");
  StagedFile staged(path);
  if (ending == ".gpkg")
    writeGeoPackage(path, staged.place(), layers, wkt, monitor);
  else
    writeDxf(path, staged.place(), layers, monitor);
  staged.publish();
}

} // namespace linelet::io
