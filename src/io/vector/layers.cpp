// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/vector_file.h>

#include <algorithm>
#include <cmath>

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <linelet/io/file_error.h>
#include <linelet/io/output_file.h>

#include "geojson.h"
#include "io/files.h"
#include "io/reference_systems.h"
#include "io/staged_file.h"
#include "layer_csv.h"
#include "layer_formats.h"
#include "layer_writer.h"
#include "reference.h"
#include "reproject.h"

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

/** GeoPackage's undefined Cartesian system. Without a system, GDAL assumes degrees. */
Reference
unknownPlane()
{
  Reference plane(new OGRSpatialReference);
  plane->SetLocalCS("Undefined Cartesian SRS");
  return plane;
}

OGRwkbGeometryType
geometryOf(VectorLayer::Kind kind)
{
  static constexpr OGRwkbGeometryType types[] = {
      wkbPoint25D, wkbLineString25D, wkbPolygon25D};
  return types[static_cast<std::size_t>(kind)];
}

void
writeGeoPackage(const std::string& path,
                const std::string& staged,
                const std::vector<VectorLayer>& layers,
                const std::string& wkt,
                const ProgressMonitor* monitor)
{
  // No time stamps: the same input gives the same bytes.
  const GdalOption date("OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z");
  Reference system = parseReference(wkt);
  if (system == nullptr)
    system = unknownPlane();
  CPLErrorReset();
  LayerWriter writer(path, staged, "GPKG");
  for (const VectorLayer& content : layers) {
    OGRLayer* layer =
        writer.makeLayer(content.name, geometryOf(content.kind), system.get());
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

/** DXF has layers and texts instead of attributes. */
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

/** Writes layers with a driver that needs no special treatment. */
void
writeByDriver(const std::string& path,
              const std::string& staged,
              const char* driver,
              const std::vector<VectorLayer>& layers,
              const std::string& wkt,
              const ProgressMonitor* monitor)
{
  const Reference system = parseReference(wkt);
  CPLErrorReset();
  LayerWriter writer(path, staged, driver);
  for (const VectorLayer& content : layers) {
    OGRLayer* layer =
        writer.makeLayer(content.name, geometryOf(content.kind), system.get());
    writer.makeFields(*layer, content);
    for (const VectorFeature& feature : content.features) {
      throwIfCanceled(monitor);
      const auto out = writer.makeFeature(*layer, content.kind, feature.vertices);
      writer.setAttributes(*out, feature);
      for (int field = 0; field < out->GetFieldCount(); ++field)
        if (out->GetFieldDefnRef(field)->GetType() == OFTReal &&
            std::isnan(out->GetFieldAsDouble(field)))
          out->SetFieldNull(field); // few formats have NaN
      writer.add(*layer, *out);
    }
  }
  writer.close();
}

/** RFC 7946: all layers in one collection, in degrees of WGS 84. */
void
writeGeoJson(const std::string& path,
             const std::string& staged,
             const std::vector<VectorLayer>& layers,
             const std::string& wkt,
             const ProgressMonitor* monitor)
{
  const Reference system = parseReference(wkt);
  // A tenth of a millimeter.
  const char* const options[] = {
      "RFC7946=YES", "COORDINATE_PRECISION=9", "WRITE_NAME=NO", nullptr};
  CPLErrorReset();
  LayerWriter writer(path, staged, "GeoJSON");
  OGRLayer* layer = writer.makeLayer("linelet", wkbUnknown, system.get(), options);
  writer.makeField(*layer, "layer", OFTString);
  for (const VectorLayer& content : layers)
    writer.makeFields(*layer, content);
  for (const VectorLayer& content : layers)
    for (const VectorFeature& feature : content.features) {
      throwIfCanceled(monitor);
      const auto out = writer.makeFeature(*layer, content.kind, feature.vertices);
      out->SetField("layer", content.name.c_str());
      writer.setAttributes(*out, feature);
      for (const auto& [name, value] : feature.attributes)
        if (const auto* real = std::get_if<double>(&value);
            real != nullptr && !std::isfinite(*real))
          out->SetFieldNull(out->GetFieldIndex(name.c_str()));
      writer.add(*layer, *out);
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

/** The system to write in: the requested one, or that of \a wkt. */
std::string
targetOf(const std::string& path, const std::string& wkt, const VectorOptions& options)
{
  const std::string ending = endingOf(path);
  const bool global = (ending == ".geojson" && !options.keep_crs) || ending == ".kml";
  if (!options.output_crs.empty()) {
    if (global)
      throw FileError(path +
                      ": is in WGS 84 by its standard, whatever --output-crs "
                      "says; use .gpkg" +
                      (ending == ".kml" ? "" : ", or add --keep-crs"));
    return declaredReference(options.output_crs, "--output-crs");
  }
  return global && isSystem(wkt) ? declaredReference("EPSG:4326") : wkt;
}

} // namespace

void
writeLayers(const std::string& path,
            const std::vector<VectorLayer>& layers,
            const std::string& wkt,
            std::vector<std::string>* warnings,
            ProgressMonitor* monitor,
            const VectorOptions& options)
{
  throwIfCanceled(monitor);
  const std::string ending = endingOf(path);
  const std::string driver = ending == ".csv" ? "" : layerDriver(path);
  const std::string target = targetOf(path, wkt, options);
  if (target != wkt) {
    VectorOptions done = options;
    done.output_crs.clear();
    if (!isSystem(wkt) && !isEmpty(layers))
      throw FileError(path + ": --output-crs needs to know the reference system of the "
                             "input, which has none; declare it with --crs");
    const auto there = reprojected(path, layers, wkt, target);
    return writeLayers(path, there, target, warnings, monitor, done);
  }
  const bool unknown = !isSystem(wkt);
  if (unknown && (ending == ".geojson" || ending == ".kml") && warnings != nullptr &&
      !isEmpty(layers))
    warnings->push_back(
        path + ": the input has no reference system, so readers of " +
        (ending == ".kml" ? "KML" : "GeoJSON") +
        " take the coordinates for degrees; a .gpkg records it as unknown");
  if (ending == ".geojson" && (options.keep_crs || unknown)) {
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
  StagedFile staged(path);
  if (ending == ".gpkg")
    writeGeoPackage(path, staged.place(), layers, wkt, monitor);
  else if (ending == ".dxf")
    writeDxf(path, staged.place(), layers, monitor);
  else if (ending == ".geojson")
    writeGeoJson(path, staged.place(), layers, wkt, monitor);
  else
    writeByDriver(path, staged.place(), driver.c_str(), layers, wkt, monitor);
  staged.publish();
}

} // namespace linelet::io
