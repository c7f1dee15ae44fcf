// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Curves in vector formats, as read by GDAL.

#include <filesystem>
#include <string>

#include "io/vector/curve_example.h"

using namespace linelet;
using namespace linelet::test;

namespace {

/** The vertices of a feature equal those of \a curve to the last bit. */
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

TEST(CurveFiles, AreReprojectedOnRequest)
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
    if (ending != std::string("dxf")) {
      EXPECT_EQ(referenceName(wkt), "ETRS89 / UTM zone 33N");
    }
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

TEST(CurveFiles, CoordinatesOfAnUnknownSystemAreNotDegrees)
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
  const VectorLayer lines{"wires",
                          VectorLayer::Kind::Lines,
                          {{{{0, 0, 0}, {1, 1, 1}}, {{"id", std::int64_t{7}}}, {}, {}}},
                          {}};
  const VectorLayer points{
      "poles",
      VectorLayer::Kind::Points,
      {{{{5, 6, 7}}, {{"height", 31.5}, {"name", std::string("a \"b\"\n\\")}}, {}, {}}},
      {}};
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
