// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/vector_file.h>

#include <linelet/io/output_check.h>

#include "curve_writers.h"
#include "io/files.h"
#include "io/source.h"
#include "io/text/text_scan.h"

namespace linelet::io {

namespace {

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

/** Reads the curves of an OBJ text. */
class ObjReader {
public:
  ObjReader(const Source& source, const Point& shift) : source_(source), shift_(shift)
  {
  }

  CurveNetwork
  read()
  {
    Lines lines(source_.bytes);
    for (std::string_view line; lines.next(line);) {
      number_ = lines.number();
      const std::string_view word = takeWord(line);
      if (word == "v")
        readVertex(line);
      else if (word == "l")
        readLine(line);
    }
    return std::move(network_);
  }

private:
  [[noreturn]] void
  fail(const std::string& what) const
  {
    source_.fail("line " + std::to_string(number_) + ": " + what);
  }

  void
  readVertex(std::string_view line)
  {
    Point point;
    for (double& value : point.reshaped())
      if (!parseNumber(takeWord(line), value))
        fail("a vertex needs three numbers");
    vertices_.push_back(point - shift_);
  }

  void
  readLine(std::string_view line)
  {
    std::vector<std::size_t> places;
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
      const std::string_view place = word.substr(0, word.find('/'));
      const auto count = static_cast<long long>(vertices_.size());
      long long value = 0;
      const bool read = parseNumber(place, value);
      if (read && value < 0)
        value += count + 1; // counted back from the newest
      if (!read || value < 1 || value > count)
        fail("'" + cleanName(word) + "' is none of the " + std::to_string(count) +
             " vertices before it");
      places.push_back(static_cast<std::size_t>(value - 1));
    }
    if (places.size() < 2)
      fail("a line needs at least two vertices");
    Curve curve;
    curve.closed =
        places.size() > 2 && vertices_[places.front()] == vertices_[places.back()];
    if (curve.closed) {
      places.pop_back();
      curve.front.kind = curve.back.kind = EndKind::Loop;
    }
    for (std::size_t place : places)
      curve.points.push_back(vertices_[place]);
    network_.curves.push_back(std::move(curve));
  }

  const Source& source_;
  Point shift_;
  Points vertices_;
  CurveNetwork network_;
  std::size_t number_ = 0;
};

[[noreturn]] void
noCurveFormat(const std::string& path)
{
  throw FileError(path + ": the ending '" + endingOf(path) +
                  "' names no format of curves; use .obj, .ply, .vtk, .csv, .geojson, "
                  ".gpkg or .dxf");
}

} // namespace

void
checkCurvesOutput(const std::string& path)
{
  const std::string ending = endingOf(path);
  for (const char* known :
       {".obj", ".ply", ".vtk", ".csv", ".geojson", ".gpkg", ".dxf"})
    if (ending == known)
      return checkWritable(path);
  noCurveFormat(path);
}

void
writeCurves(const std::string& path,
            const CurveNetwork& network,
            const Point& shift,
            const std::string& wkt,
            std::vector<std::string>* warnings,
            ProgressMonitor* monitor)
{
  throwIfCanceled(monitor);
  const std::string ending = endingOf(path);
  if (ending == ".obj")
    writeText(path, curvesAsObj(network, shift));
  else if (ending == ".ply")
    writeText(path, curvesAsPly(network, shift));
  else if (ending == ".vtk")
    writeText(path, curvesAsVtk(network, shift));
  else if (ending == ".csv")
    writeText(path, curvesAsCsv(network, shift));
  else if (ending == ".geojson" || ending == ".gpkg" || ending == ".dxf")
    writeLayers(path, {layerOf(network, shift)}, wkt, warnings, monitor);
  else
    noCurveFormat(path);
}

CurveNetwork
readCurves(const std::string& path, const Point& shift)
{
  if (endingOf(path) != ".obj")
    throw FileError(path + ": curves are read from .obj only");
  const MappedFile file(path);
  Source source;
  source.name = path;
  source.bytes = file.bytes();
  return ObjReader(source, shift).read();
}

} // namespace linelet::io
