// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Vertices of vector files as points; the files are made by GDAL and by hand.

#include <fstream>
#include <string>

#include <linelet/io/point_file.h>

#include "io/vector/curve_example.h"

using namespace linelet;
using namespace linelet::test;

namespace {

void
write(const std::string& path, const std::string& text)
{
  std::ofstream(path) << text;
}

std::vector<double>
valuesOf(const io::Cloud& cloud, const std::string& name)
{
  std::vector<double> values;
  const io::Column* column = cloud.find(name);
  for (std::size_t i = 0; column != nullptr && i < cloud.points.size(); ++i)
    values.push_back(io::valueAt(*column, i));
  return values;
}

TEST(VertexReader, RingsOfAShapefileInOrderWithNumbersAndReference)
{
  GDALAllRegister();
  const Folder folder;
  const std::string path = folder.file("coast.shp");
  {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("ESRI Shapefile");
    ASSERT_NE(driver, nullptr);
    const std::unique_ptr<GDALDataset> file(
        driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    OGRSpatialReference reference;
    reference.importFromEPSG(25832);
    OGRLayer* layer = file->CreateLayer("coast", &reference, wkbPolygon, nullptr);
    OGRFieldDefn depth("depth", OFTReal), name("name", OFTString);
    layer->CreateField(&depth);
    layer->CreateField(&name);
    for (int island = 0; island < 2; ++island) {
      const double x = 565000.25 + 100 * island;
      OGRLinearRing ring;
      // Clockwise, like the outer rings of shapefiles, so that GDAL keeps their order.
      for (const auto& [dx, dy] :
           {std::pair{0., 0.}, {0., 10.}, {10., 10.}, {10., 0.}, {0., 0.}})
        ring.addPoint(x + dx, 5930000.5 + dy);
      OGRPolygon polygon;
      polygon.addRing(&ring);
      const OGRFeatureUniquePtr feature(
          OGRFeature::CreateFeature(layer->GetLayerDefn()));
      feature->SetGeometry(&polygon);
      feature->SetField("depth", 1.5 + island);
      feature->SetField("name", "island");
      ASSERT_EQ(layer->CreateFeature(feature.get()), OGRERR_NONE);
    }
  }
  std::vector<std::string> warnings;
  const io::Cloud cloud = io::readCloud(path, {}, &warnings);
  ASSERT_EQ(cloud.points.size(), 8U); // a ring's last vertex is its first
  const double dx[] = {0, 0, 10, 10}, dy[] = {0, 10, 10, 0};
  for (std::size_t i = 0; i < 8; ++i) {
    const Point p = cloud.shift + cloud.points[i];
    EXPECT_EQ(p.x(), 565000.25 + (i < 4 ? 0 : 100) + dx[i % 4]) << i;
    EXPECT_EQ(p.y(), 5930000.5 + dy[i % 4]) << i;
    EXPECT_EQ(p.z(), 0);
  }
  EXPECT_EQ(valuesOf(cloud, "line"), (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(valuesOf(cloud, "depth"),
            (std::vector<double>{1.5, 1.5, 1.5, 1.5, 2.5, 2.5, 2.5, 2.5}));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("name"), std::string::npos);
  OGRSpatialReference reference;
  ASSERT_EQ(reference.importFromWkt(cloud.wkt.c_str()), OGRERR_NONE);
  reference.AutoIdentifyEPSG();
  EXPECT_STREQ(reference.GetAuthorityCode(nullptr), "25832");
}

TEST(VertexReader, EveryKindOfGeometry)
{
  const Folder folder;
  const std::string path = folder.file("all.geojson");
  write(path, R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"x": 7}, "geometry":
      {"type": "Point", "coordinates": [1, 2, 3]}},
    {"type": "Feature", "properties": {"x": null}, "geometry":
      {"type": "MultiLineString", "coordinates": [[[0, 0, 1], [1, 0, 2]], [[5, 5, 5], [6, 6, 6]]]}},
    {"type": "Feature", "properties": {"x": 9}, "geometry": null},
    {"type": "Feature", "properties": {"x": 10}, "geometry":
      {"type": "GeometryCollection", "geometries": [
        {"type": "MultiPoint", "coordinates": [[8, 8, 8], [9, 9, 9]]}]}}]})");
  std::vector<std::string> warnings;
  const io::Cloud cloud = io::readCloud(path, {}, &warnings);
  const std::vector<Point> expected = {
      {1, 2, 3}, {0, 0, 1}, {1, 0, 2}, {5, 5, 5}, {6, 6, 6}, {8, 8, 8}, {9, 9, 9}};
  ASSERT_EQ(cloud.points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(Point(cloud.shift + cloud.points[i]), expected[i]) << i;
  EXPECT_EQ(valuesOf(cloud, "line"), (std::vector<double>{0, 1, 1, 2, 2, 3, 4}));
  // An attribute may have the name of a coordinate.
  const std::vector<double> numbers = valuesOf(cloud, "x_2");
  ASSERT_EQ(numbers.size(), expected.size());
  EXPECT_EQ(numbers[0], 7);
  EXPECT_TRUE(std::isnan(numbers[1]));
  EXPECT_EQ(numbers[6], 10);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("1 feature"), std::string::npos) << warnings[0];
}

TEST(VertexReader, UnreadableFilesAreNamed)
{
  const Folder folder;
  for (const char* name : {"bad.shp", "bad.gpkg", "bad.geojson"}) {
    const std::string path = folder.file(name);
    write(path, "no such thing");
    try {
      io::readCloud(path);
      ADD_FAILURE() << name;
    }
    catch (const io::FileError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
    }
  }
  const std::string empty = folder.file("empty.geojson");
  write(empty, R"({"type": "FeatureCollection", "features": []})");
  EXPECT_THROW(io::readCloud(empty), io::FileError);
  io::Cloud cloud;
  cloud.points.push_back(Point::Zero());
  EXPECT_THROW(io::writeCloud(folder.file("out.shp"), cloud), io::FileError);
  EXPECT_THROW(io::writeCloud(folder.file("out.gpkg"), cloud), io::FileError);
}

} // namespace
