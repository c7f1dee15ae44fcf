// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Curves read back from files.

#include <string>

#include "io/vector/curve_example.h"

using namespace linelet;
using namespace linelet::test;

// Files written for other programs can be read again, vertex by vertex, open or closed.
TEST(CurveFiles, AreReadBackFromEveryFormat)
{
  const Folder folder;
  const CurveNetwork network = example();
  for (const char* ending : {"obj", "ply", "vtk", "csv", "geojson", "gpkg", "dxf"}) {
    SCOPED_TRACE(ending);
    const std::string file = folder.file(std::string("back.") + ending);
    writeCurves(file, network, utm_shift, wktOf(25832), nullptr, nullptr, kept);
    std::string wkt;
    const CurveNetwork back = readCurves(file, utm_shift, &wkt);
    ASSERT_EQ(back.curves.size(), network.curves.size());
    for (std::size_t c = 0; c < back.curves.size(); ++c) {
      EXPECT_EQ(back.curves[c].closed, network.curves[c].closed);
      ASSERT_EQ(back.curves[c].points.size(), network.curves[c].points.size());
      for (std::size_t i = 0; i < back.curves[c].points.size(); ++i)
        EXPECT_LE((back.curves[c].points[i] - network.curves[c].points[i]).norm(),
                  1e-8);
    }
    const bool tells =
        ending == std::string("geojson") || ending == std::string("gpkg");
    EXPECT_EQ(referenceName(wkt), tells ? "ETRS89 / UTM zone 32N" : "");
  }
  // Without a reference system, none is invented.
  for (const char* ending : {"geojson", "gpkg", "dxf"}) {
    const std::string file = folder.file(std::string("bare.") + ending);
    writeCurves(file, network);
    std::string wkt;
    EXPECT_EQ(readCurves(file, Point::Zero(), &wkt).curves.size(), 2U) << ending;
    EXPECT_EQ(wkt, "") << ending;
    writeCurves(file, {});
    EXPECT_TRUE(readCurves(file).curves.empty()) << ending;
  }
}

TEST(CurveFiles, LayersAreReadForTheirLines)
{
  const Folder folder;
  VectorLayer lines, points;
  lines.name = "wires";
  lines.features = {{{{0, 0, 0}, {1, 0, 0}}, {{"id", std::int64_t{1}}}, "w", "label"}};
  points.name = "pylons";
  points.kind = VectorLayer::Kind::Points;
  points.features = {{{{5, 5, 5}}, {{"id", std::int64_t{1}}}, "", ""}};
  for (const char* ending : {"geojson", "gpkg", "dxf"}) {
    const std::string file = folder.file(std::string("layers.") + ending);
    writeLayers(file, {lines, points}, wktOf(25832));
    const CurveNetwork back = readCurves(file);
    ASSERT_EQ(back.curves.size(), 1U) << ending;
    EXPECT_EQ(back.curves[0].points.size(), 2U) << ending;
  }
}

// Files by others: outlines of areas and arcs are curves, too.
TEST(CurveFiles, RingsAreClosedCurvesAndArcsAreChords)
{
  const Folder folder;
  const std::string area = folder.file("area.geojson");
  std::ofstream(area) << R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {}, "geometry": {"type": "MultiPolygon",
      "coordinates": [[[[0, 0], [9, 0], [9, 9], [0, 0]],
                       [[3, 1], [8, 1], [8, 6], [3, 1]]]]}}]})";
  const CurveNetwork rings = readCurves(area);
  ASSERT_EQ(rings.curves.size(), 2U); // the outline and its hole
  for (const Curve& ring : rings.curves) {
    EXPECT_TRUE(ring.closed);
    EXPECT_EQ(ring.points.size(), 3U);
  }
  const std::string gpkg = folder.file("arc.gpkg");
  {
    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    const std::unique_ptr<GDALDataset> file(
        driver->Create(gpkg.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    OGRLayer* layer = file->CreateLayer("arc", nullptr, wkbCircularString, nullptr);
    OGRCircularString half;
    for (const auto& [x, y] : {std::pair{-1., 0.}, {0., 1.}, {1., 0.}})
      half.addPoint(x, y);
    const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer->GetLayerDefn()));
    feature->SetGeometry(&half);
    ASSERT_EQ(layer->CreateFeature(feature.get()), OGRERR_NONE);
  }
  const CurveNetwork chords = readCurves(gpkg);
  ASSERT_EQ(chords.curves.size(), 1U);
  EXPECT_NEAR(length(chords.curves[0]), std::acos(-1), 1e-2);
  for (const Point& p : chords.curves[0].points)
    EXPECT_NEAR(p.norm(), 1, 1e-9);
}

TEST(CurveFiles, BrokenOnesAreReported)
{
  const Folder folder;
  const std::pair<const char*, const char*> files[] = {
      {"a.ply", ""},
      {"b.ply", "ply\nformat binary_little_endian 1.0\nend_header\n"},
      {"c.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"},
      {"d.ply",
       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nelement edge 1\n"
       "property int vertex1\nproperty int vertex2\nend_header\n0\n0 7\n"},
      {"a.vtk", "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\n"},
      {"b.vtk",
       "x\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\nLINES 1 3\n2 0 9\n"},
      {"c.vtk", "x\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0\n"},
      {"a.csv", "x,y,z\n0,0,0\n"},
      {"b.csv", "curve,x,y,z\n0,0,zero,0\n"},
      {"a.geojson", "{"},
      {"a.gpkg", "no database"},
      {"a.dxf", ""}};
  for (const auto& [name, bytes] : files) {
    writeBytes(folder.file(name), bytes);
    try {
      readCurves(folder.file(name));
      ADD_FAILURE() << name;
    }
    catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos)
          << error.what();
    }
  }
}
