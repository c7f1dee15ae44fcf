// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>
#include <map>
#include <set>

#include "geometry_walk.h"
#include "io/columns.h"
#include "io/vector_points.h"
#include "layer_formats.h"

namespace linelet::io {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/** \brief Vertices, each with the number of its line and the numbers among the
 * attributes of its feature. */
struct Vertices {
  std::vector<double> x, y, z;
  std::vector<std::int32_t> line; ///< of every vertex, from 0
  std::map<std::string, std::vector<double>> numbers;
  std::set<std::string> texts; ///< attributes that are not numbers
  std::int32_t lines = 0;
  std::size_t without_geometry = 0; ///< features

  void
  add(OGRLayer& layer, const ProgressMonitor* monitor)
  {
    for (const OGRFeatureUniquePtr& feature : layer) {
      throwIfCanceled(monitor);
      const std::size_t first = x.size();
      forEachPart(feature->GetGeometryRef(), *this);
      if (x.size() == first)
        ++without_geometry;
      else
        addAttributes(*feature, first);
    }
  }

  void
  operator()(const OGRPoint& point)
  {
    if (point.IsEmpty() == 0)
      addVertex(point.getX(), point.getY(), point.getZ());
    ++lines;
  }

  /** \brief A ring ends with its first vertex, which is not counted twice. */
  void
  operator()(const OGRLineString& vertices)
  {
    const int count = vertices.getNumPoints();
    const bool closed = count > 2 && vertices.get_IsClosed() != 0;
    for (int i = 0; i < count - (closed ? 1 : 0); ++i)
      addVertex(vertices.getX(i), vertices.getY(i), vertices.getZ(i));
    ++lines;
  }

private:
  void
  addVertex(double vx, double vy, double vz)
  {
    x.push_back(vx);
    y.push_back(vy);
    z.push_back(vz);
    line.push_back(lines);
  }

  /** \brief Gives the attributes of \a feature to the vertices from \a first on. */
  void
  addAttributes(const OGRFeature& feature, std::size_t first)
  {
    for (int i = 0; i < feature.GetFieldCount(); ++i) {
      const OGRFieldDefn& field = *feature.GetFieldDefnRef(i);
      const OGRFieldType type = field.GetType();
      if (type != OFTInteger && type != OFTInteger64 && type != OFTReal) {
        texts.insert(field.GetNameRef());
        continue;
      }
      std::vector<double>& values = numbers[field.GetNameRef()];
      values.resize(first, nan);
      values.resize(line.size(),
                    feature.IsFieldSetAndNotNull(i) != 0 ? feature.GetFieldAsDouble(i)
                                                         : nan);
    }
  }
};

void
warn(const Source& source, const Vertices& vertices)
{
  if (vertices.without_geometry > 0)
    source.warn(std::to_string(vertices.without_geometry) +
                (vertices.without_geometry == 1
                     ? " feature has no geometry and is left out"
                     : " features have no geometry and are left out"));
  std::string names;
  for (const std::string& name : vertices.texts)
    names += (names.empty() ? "" : ", ") + name;
  if (!names.empty())
    source.warn("attributes that are not numbers are left out: " + names);
}

Cloud
readVertices(const Source& source)
{
  const Complaints complaints;
  const auto dataset = openDataset(source.name, complaints);
  Vertices vertices;
  std::string wkt;
  for (OGRLayer* layer : dataset->GetLayers()) {
    const std::string of_layer = referenceOf(*layer);
    if (wkt.empty())
      wkt = of_layer;
    else if (!of_layer.empty() && of_layer != wkt)
      source.fail("its layers have several reference systems; convert one layer at a "
                  "time (ogr2ogr)");
    vertices.add(*layer, source.monitor);
  }
  if (vertices.x.empty())
    source.fail("there are no vertices" +
                (complaints.first().empty() ? "" : " (" + complaints.first() + ")"));
  warn(source, vertices);
  const std::size_t count = vertices.x.size();
  UniqueNames names;
  for (const char* taken : {"x", "y", "z", "line"})
    names.take(taken);
  std::vector<Column> columns = {
      {"x", std::move(vertices.x), {}},
      {"y", std::move(vertices.y), {}},
      {"z", std::move(vertices.z), {}},
      {"line", std::move(vertices.line), "number of the line, from 0"}};
  for (auto& [name, values] : vertices.numbers) {
    values.resize(count, nan);
    columns.push_back({names.take(cleanName(name)), std::move(values), {}});
  }
  Cloud cloud = cloudFromColumns(source, std::move(columns));
  cloud.wkt = wkt;
  cloud.format = std::string("vertices of ") + dataset->GetDriverName();
  return cloud;
}

bool
reads(const std::string& path)
{
  return !findReadLayerDriver(path).empty();
}

const VectorPoints reader = {reads, readVertices};

} // namespace

} // namespace linelet::io

// Linking linelet::vector references this symbol, which pulls in this object.
extern "C" LINELET_PUBLIC const bool linelet_vector_points;
const bool linelet_vector_points =
    (linelet::io::setVectorPoints(&linelet::io::reader), true);
