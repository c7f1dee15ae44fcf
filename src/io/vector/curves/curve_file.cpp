// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/vector_file.h>

#include <array>
#include <cmath>
#include <filesystem>

#include <linelet/io/hdf5_file.h>
#include <linelet/io/output_check.h>
#include <linelet/io/output_file.h>

#include "csv_curves.h"
#include "io/files.h"
#include "io/vector/layer_formats.h"
#include "io/vector/layer_reader.h"
#include "obj_curves.h"
#include "ply_curves.h"
#include "vtk_curves.h"

namespace linelet::io {

namespace {

/** A text format that linelet writes itself. */
struct TextFormat {
  const char* ending;
  CurveNetwork (*read)(const Source& source);
  std::string (*write)(const CurveNetwork& network, const Point& shift);
};

constexpr std::array<TextFormat, 4> text_formats = {
    {{".obj", curvesFromObj, curvesAsObj},
     {".ply", curvesFromPly, curvesAsPly},
     {".vtk", curvesFromVtk, curvesAsVtk},
     {".csv", curvesFromCsv, curvesAsCsv}}};

/** Null if there is none. */
const TextFormat*
textFormatOf(const std::string& ending)
{
  for (const TextFormat& format : text_formats)
    if (ending == format.ending)
      return &format;
  return nullptr;
}

VectorLayer
layerOf(const CurveNetwork& network, const Point& shift)
{
  VectorLayer layer;
  layer.name = "curves";
  for (std::size_t i = 0; i < network.curves.size(); ++i) {
    const Curve& curve = network.curves[i];
    if (curve.points.size() < 2)
      continue;
    VectorFeature feature;
    for (const Point& point : curve.points)
      feature.vertices.push_back(shift + point);
    if (curve.closed)
      feature.vertices.push_back(feature.vertices.front());
    feature.attributes = {{"curve", static_cast<std::int64_t>(i)},
                          {"closed", std::int64_t{curve.closed}},
                          {"length", length(curve)},
                          {"front", std::string(nameOf(curve.front.kind))},
                          {"back", std::string(nameOf(curve.back.kind))}};
    // The published presets do not measure them.
    if (std::isfinite(curve.noise + curve.density + curve.evidence)) {
      feature.attributes.emplace_back("noise", curve.noise);
      feature.attributes.emplace_back("density", curve.density);
      feature.attributes.emplace_back("evidence", curve.evidence);
    }
    layer.features.push_back(std::move(feature));
  }
  return layer;
}

void
writeText(const std::string& path, const std::string& text)
{
  OutputFile file(path);
  file.write(text);
  file.commit();
}

[[noreturn]] void
noCurveFormat(const std::string& path)
{
  throw FileError(path + ": the ending '" + endingOf(path) +
                  "' names no format of curves; use .obj, .ply, .vtk, .csv, .geojson, "
                  ".gpkg, .dxf, .h5, .kml, .fgb, .shz or another that GDAL writes");
}

} // namespace

void
checkCurvesOutput(const std::string& path)
{
  const std::string ending = endingOf(path);
  if (textFormatOf(ending) == nullptr && ending != ".h5" &&
      findLayerDriver(path).empty())
    noCurveFormat(path);
  checkWritable(path);
}

void
writeCurves(const std::string& path,
            const CurveNetwork& network,
            const Point& shift,
            const std::string& wkt,
            std::vector<std::string>* warnings,
            ProgressMonitor* monitor,
            const VectorOptions& options)
{
  throwIfCanceled(monitor);
  const std::string ending = endingOf(path);
  const TextFormat* text = textFormatOf(ending);
  if (text != nullptr && !options.output_crs.empty())
    throw FileError(
        path + ": the ending '" + ending +
        "' names a format without reference systems, which --output-crs has "
        "no effect on; use .gpkg");
  if (text != nullptr)
    writeText(path, text->write(network, shift));
  else if (ending == ".h5")
    writeHdf5Curves(path, network, shift, wkt);
  else if (findLayerDriver(path).empty())
    noCurveFormat(path);
  else
    writeLayers(path, {layerOf(network, shift)}, wkt, warnings, monitor, options);
}

CurveNetwork
readCurves(const std::string& path, const Point& shift, std::string* wkt)
{
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored))
    throw FileError(path + ": is a folder; name a file of curves");
  const std::string ending = endingOf(path);
  const MappedFile file(path);
  Source source;
  source.name = path;
  source.bytes = file.bytes();
  CurveNetwork network;
  if (ending == ".h5") {
    network = readHdf5Curves(path, wkt);
    for (Junction& junction : network.junctions)
      junction.position -= shift;
  }
  else if (const TextFormat* text = textFormatOf(ending))
    network = text->read(source);
  else if (!findLayerDriver(path).empty())
    network = curvesFromLayers(source, wkt);
  else
    noCurveFormat(path);
  for (Curve& curve : network.curves)
    for (Point& point : curve.points)
      point -= shift;
  return network;
}

} // namespace linelet::io
