// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Curves as other software reads them: GDAL for vector formats, words for the rest.

#include <map>
#include <memory>
#include <sstream>

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <linelet/io/point_file.h>
#include <linelet/io/vector_file.h>

#include "io/file_helpers.h"

using namespace linelet;
using namespace linelet::io;
using namespace linelet::test;

namespace {

const Point utm_shift(689012.0, 5527515.0, 210.0);

/** GeoJSON in the coordinates of the input. */
const VectorOptions kept{"", true};

/** An open and a closed curve, with coordinates that need every digit. */
CurveNetwork
example()
{
  CurveNetwork network;
  Curve open;
  open.points = {{0.123456789, 1.0 / 3, 0}, {1, 2, 3.0000001}, {7.7, -0.1, 1e-7}};
  open.back.kind = EndKind::Bounds;
  Curve closed;
  closed.points = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  closed.closed = true;
  closed.front.kind = closed.back.kind = EndKind::Loop;
  network.curves = {open, closed};
  return network;
}

std::string
wktOf(int code, int height = 0)
{
  OGRSpatialReference system;
  system.importFromEPSG(code);
  if (height != 0) {
    OGRSpatialReference plane = system, vertical;
    vertical.importFromEPSG(height);
    system.SetCompoundCS("both", &plane, &vertical);
  }
  char* text = nullptr;
  system.exportToWkt(&text);
  const std::string wkt = text;
  CPLFree(text);
  return wkt;
}

std::unique_ptr<GDALDataset>
open(const std::string& path)
{
  GDALAllRegister();
  return std::unique_ptr<GDALDataset>(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
}

/** The vertices of a feature are those of \a curve, to the last bit. */
void
expectVertices(OGRFeature& feature, const Curve& curve, double tolerance)
{
  const OGRLineString* line = feature.GetGeometryRef()->toLineString();
  const std::size_t count = curve.points.size();
  ASSERT_EQ(line->getNumPoints(), static_cast<int>(count + (curve.closed ? 1 : 0)));
  for (int i = 0; i < line->getNumPoints(); ++i) {
    const Point expected =
        utm_shift + curve.points[static_cast<std::size_t>(i) % count];
    EXPECT_NEAR(line->getX(i), expected.x(), tolerance);
    EXPECT_NEAR(line->getY(i), expected.y(), tolerance);
    EXPECT_NEAR(line->getZ(i), expected.z(), tolerance);
  }
}

} // namespace

class VectorFormat : public testing::TestWithParam<const char*> {};

TEST_P(VectorFormat, HoldsVerticesAttributesAndReference)
{
  const Folder folder;
  const CurveNetwork network = example();
  const std::string path = folder.file(std::string("out.") + GetParam());
  writeCurves(path, network, utm_shift, wktOf(25832), nullptr, nullptr, kept);
  const auto dataset = open(path);
  ASSERT_NE(dataset, nullptr);
  ASSERT_EQ(dataset->GetLayerCount(), 1);
  OGRLayer& layer = *dataset->GetLayer(0);
  ASSERT_EQ(layer.GetFeatureCount(), 2);
  const bool dxf = std::string(GetParam()) == "dxf";
  for (const Curve& curve : network.curves) {
    const OGRFeatureUniquePtr feature(layer.GetNextFeature());
    // GDAL writes DXF with 15 digits: half a unit of the last one at 5527515.
    expectVertices(*feature, curve, dxf ? 5e-9 : 0);
    if (dxf) {
      EXPECT_STREQ(feature->GetFieldAsString("Layer"), "curves");
      continue;
    }
    EXPECT_EQ(feature->GetFieldAsInteger("closed"), curve.closed ? 1 : 0);
    EXPECT_EQ(feature->GetFieldAsDouble("length"), length(curve));
    EXPECT_EQ(feature->GetFieldAsString("front"),
              std::string(nameOf(curve.front.kind)));
    EXPECT_EQ(feature->GetFieldAsString("back"), std::string(nameOf(curve.back.kind)));
  }
  if (!dxf) {
    ASSERT_NE(layer.GetSpatialRef(), nullptr);
    EXPECT_STREQ(layer.GetSpatialRef()->GetAuthorityCode(nullptr), "25832");
  }
}

TEST_P(VectorFormat, IsTheSameEachTime)
{
  const Folder folder;
  const std::string path = folder.file(std::string("out.") + GetParam());
  writeCurves(path, example(), utm_shift, wktOf(25832));
  const std::string first = bytesOf(path);
  writeCurves(path, example(), utm_shift, wktOf(25832));
  EXPECT_TRUE(first == bytesOf(path));
}

TEST_P(VectorFormat, OfNoCurvesIsAFile)
{
  const Folder folder;
  const std::string path = folder.file(std::string("out.") + GetParam());
  writeCurves(path, {});
  EXPECT_TRUE(std::filesystem::exists(path));
}

TEST_P(VectorFormat, ThatCannotBeWrittenSaysSo)
{
  const Folder folder;
  const std::string path = folder.file(std::string("none/out.") + GetParam());
  EXPECT_THROW(writeCurves(path, example()), FileError);
}

INSTANTIATE_TEST_SUITE_P(Formats,
                         VectorFormat,
                         testing::Values("geojson", "gpkg", "dxf"),
                         [](const auto& parameter) { return parameter.param; });

TEST(CurveFiles, GeoJsonNamesCompoundSystems)
{
  const Folder folder;
  writeCurves(folder.file("a.geojson"),
              example(),
              utm_shift,
              wktOf(28992, 5709),
              nullptr,
              nullptr,
              kept);
  const auto dataset = open(folder.file("a.geojson"));
  const OGRSpatialReference* system = dataset->GetLayer(0)->GetSpatialRef();
  ASSERT_NE(system, nullptr);
  EXPECT_TRUE(system->IsCompound());
  EXPECT_NE(bytesOf(folder.file("a.geojson")).find("EPSG::28992"), std::string::npos);
}

// 689013 5527515.5 by gdaltransform.
TEST(CurveFiles, GeoJsonIsInDegreesByItsStandard)
{
  const Folder folder;
  CurveNetwork network;
  Curve line;
  line.points = {{1, 0.5, 3.25}, {2, 0.5, 3}};
  network.curves = {line};
  const std::string file = folder.file("a.geojson");
  writeCurves(file, network, utm_shift, wktOf(25832));
  EXPECT_EQ(bytesOf(file).find("\"crs\""), std::string::npos);
  const auto dataset = open(file);
  const OGRFeatureUniquePtr feature(dataset->GetLayer(0)->GetNextFeature());
  const OGRLineString* written = feature->GetGeometryRef()->toLineString();
  EXPECT_NEAR(written->getX(0), 11.6304553570739, 1e-9);
  EXPECT_NEAR(written->getY(0), 49.8701813982145, 1e-9);
  EXPECT_NEAR(written->getZ(0), 213.25, 1e-9);
  EXPECT_STREQ(feature->GetFieldAsString("layer"), "curves");
  EXPECT_EQ(feature->GetFieldAsDouble("length"), length(line));
  std::string wkt;
  EXPECT_EQ(readCurves(file, Point::Zero(), &wkt).curves.size(), 1u);
  EXPECT_EQ(referenceName(wkt), "WGS 84");
}

TEST(CurveFiles, GoToTheSystemThatIsAskedFor)
{
  const Folder folder;
  CurveNetwork network;
  Curve line;
  line.points = {{1, 0.5, 3.25}, {2, 0.5, 3}};
  network.curves = {line};
  const VectorOptions other{"EPSG:25833", false};
  for (const char* ending : {"gpkg", "dxf", "fgb"}) {
    SCOPED_TRACE(ending);
    const std::string file = folder.file(std::string("a.") + ending);
    writeCurves(file, network, utm_shift, wktOf(25832), nullptr, nullptr, other);
    std::string wkt;
    const CurveNetwork back = readCurves(file, Point::Zero(), &wkt);
    ASSERT_EQ(back.curves.size(), 1u);
    EXPECT_NEAR(back.curves[0].points[0].x(), 257888.48936766, 1e-6);
    EXPECT_NEAR(back.curves[0].points[0].y(), 5529643.20250757, 1e-6);
    EXPECT_EQ(back.curves[0].points[0].z(), 213.25);
    if (ending != std::string("dxf"))
      EXPECT_EQ(referenceName(wkt), "ETRS89 / UTM zone 33N");
  }
  EXPECT_THROW(
      writeCurves(
          folder.file("b.gpkg"), network, utm_shift, "", nullptr, nullptr, other),
      FileError);
  for (const char* name : {"b.obj", "b.geojson"})
    EXPECT_THROW(writeCurves(folder.file(name),
                             network,
                             utm_shift,
                             wktOf(25832),
                             nullptr,
                             nullptr,
                             other),
                 FileError)
        << name;
}

TEST(CurveFiles, AreWrittenByEveryDriverOfGdal)
{
  const Folder folder;
  const CurveNetwork network = example();
  for (const char* ending : {"kml", "fgb", "shz", "gml"}) {
    SCOPED_TRACE(ending);
    const std::string file = folder.file(std::string("a.") + ending);
    writeCurves(file, network, utm_shift, wktOf(25832));
    const bool degrees = std::string(ending) == "kml";
    const CurveNetwork back = readCurves(file, degrees ? Point::Zero() : utm_shift);
    ASSERT_EQ(back.curves.size(), 2u);
    for (std::size_t c = 0; c < 2; ++c)
      ASSERT_EQ(back.curves[c].points.size(), network.curves[c].points.size());
    const Point expected =
        degrees ? Point(11.63045, 49.87018, 211) : network.curves[1].points[0];
    EXPECT_NEAR((back.curves[1].points[0] - expected).norm(), 0, degrees ? 1e-4 : 1e-3);
  }
}

TEST(CurveFiles, CoordinatesOfAnUnknownSystemAreNoDegrees)
{
  const Folder folder;
  writeCurves(folder.file("a.gpkg"), example(), utm_shift);
  const auto dataset = open(folder.file("a.gpkg"));
  const OGRSpatialReference* system = dataset->GetLayer(0)->GetSpatialRef();
  ASSERT_NE(system, nullptr);
  EXPECT_TRUE(system->IsLocal());
  EXPECT_STREQ(system->GetName(), "Undefined Cartesian SRS");
}

TEST(CurveFiles, LayersKeepTheirNamesAndKinds)
{
  const Folder folder;
  const VectorLayer lines{
      "wires",
      VectorLayer::Kind::Lines,
      {{{{0, 0, 0}, {1, 1, 1}}, {{"id", std::int64_t{7}}}, {}, {}}}};
  const VectorLayer points{"poles",
                           VectorLayer::Kind::Points,
                           {{{{5, 6, 7}},
                             {{"height", 31.5}, {"name", std::string("a \"b\"\n\\")}},
                             {},
                             {}}}};
  for (const char* name : {"a.gpkg", "a.geojson"}) {
    writeLayers(folder.file(name), {lines, points}, {});
    const auto dataset = open(folder.file(name));
    const bool one = std::string(name) == "a.geojson";
    ASSERT_EQ(dataset->GetLayerCount(), one ? 1 : 2);
    OGRLayer& layer = *dataset->GetLayer(one ? 0 : 1);
    OGRFeatureUniquePtr feature;
    while (OGRFeatureUniquePtr next{layer.GetNextFeature()})
      feature = std::move(next);
    EXPECT_EQ(feature->GetFieldAsDouble("height"), 31.5);
    EXPECT_STREQ(feature->GetFieldAsString("name"), "a \"b\"\n\\");
    EXPECT_EQ(feature->GetGeometryRef()->toPoint()->getZ(), 7);
    if (one) {
      EXPECT_STREQ(feature->GetFieldAsString("layer"), "poles");
    }
  }
}

TEST(CurveFiles, ObjIsReadBackToTheLastBit)
{
  const Folder folder;
  const CurveNetwork before = example();
  writeCurves(folder.file("a.obj"), before);
  const CurveNetwork after = readCurves(folder.file("a.obj"));
  ASSERT_EQ(after.curves.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(after.curves[i].points, before.curves[i].points);
    EXPECT_EQ(after.curves[i].closed, before.curves[i].closed);
  }
}

TEST(CurveFiles, ObjMistakesAreNamedByLine)
{
  const Folder folder;
  for (const auto& [text, what] :
       std::map<std::string, std::string>{{"v 0 0 0\nl 1 2\n", "line 2: '2'"},
                                          {"v 0 0\n", "line 1"},
                                          {"v 0 0 0\nl 1\n", "two vertices"},
                                          {"v 0 0 0\nl 1 0\n", "line 2: '0'"}}) {
    writeBytes(folder.file("a.obj"), text);
    try {
      readCurves(folder.file("a.obj"));
      ADD_FAILURE() << text;
    }
    catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos)
          << error.what();
    }
  }
  writeBytes(folder.file("a.obj"), "v 0 0 0\nv 1 0 0\nl -2/1 -1/2\n");
  EXPECT_EQ(readCurves(folder.file("a.obj")).curves.at(0).points.size(), 2U);
}

TEST(CurveFiles, PlyHasEdgesBetweenVertices)
{
  const Folder folder;
  writeCurves(folder.file("a.ply"), example(), utm_shift);
  const std::string text = bytesOf(folder.file("a.ply"));
  EXPECT_NE(text.find("element vertex 7\n"), std::string::npos);
  EXPECT_NE(text.find("element edge 6\nproperty int vertex1\nproperty int vertex2\n"),
            std::string::npos);
  EXPECT_NE(text.find("\n6 3 1\n"), std::string::npos); // closes the second curve
  EXPECT_EQ(readCloud(folder.file("a.ply")).points.size(), 7U);
}

TEST(CurveFiles, VtkLinesCountWhatTheyHold)
{
  const Folder folder;
  writeCurves(folder.file("a.vtk"), example());
  const std::string text = bytesOf(folder.file("a.vtk"));
  // 3 vertices, and 4 with the first once more, each behind its count
  EXPECT_NE(text.find("LINES 2 10\n3 0 1 2\n5 3 4 5 6 3\n"), std::string::npos);
}

TEST(CurveFiles, CsvHasARowForEachVertex)
{
  const Folder folder;
  writeCurves(folder.file("a.csv"), example(), utm_shift);
  std::istringstream lines(bytesOf(folder.file("a.csv")));
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);)
    rows.push_back(line);
  ASSERT_EQ(rows.size(), 8U);
  EXPECT_EQ(rows.front(),
            "curve,vertex,x,y,z,closed,length,front,back,noise,density,evidence");
  EXPECT_EQ(rows.back(), "1,3,689012,5527516,211,1,4,loop,loop,,,");
}

// What is written for others can be read again: by the vertex, open or closed.
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
  // Without a system of reference, none is made up.
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

TEST(CurveFiles, BrokenOnesAreSaidToBeSo)
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

TEST(CurveFiles, UnknownEndingsAreRefused)
{
  EXPECT_THROW(writeCurves("a.abc", {}), FileError);
  EXPECT_THROW(writeLayers("a.shp", {}, {}), FileError);
  EXPECT_THROW(readCurves("a.ply"), FileError);
}
