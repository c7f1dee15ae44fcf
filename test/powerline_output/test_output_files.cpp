// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <ogrsf_frmts.h>

#include <linelet/io/point_file.h>
#include <linelet/powerline/extract_power_lines.h>
#include <linelet/powerline_output/output_files.h>

#include "powerline/network_by_hand.h"

namespace {

using namespace linelet;
using namespace linelet::powerline;

constexpr const char* names[] = {"classified.las",
                                 "wires.geojson",
                                 "wires.gpkg",
                                 "wires.dxf",
                                 "hazards.geojson",
                                 "hazards.gpkg",
                                 "hazards.dxf",
                                 "clearances.csv",
                                 "crossings.csv",
                                 "fall_in.csv",
                                 "summary.json",
                                 "report.html"};

std::string
textOf(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string
utm32()
{
  OGRSpatialReference system;
  system.importFromEPSG(25832);
  char* text = nullptr;
  system.exportToWkt(&text);
  const std::string wkt = text;
  CPLFree(text);
  return wkt;
}

class OutputFiles : public testing::Test {
protected:
  void
  SetUp() override
  {
    GDALAllRegister();
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("linelet_output_") + info->name());
    std::filesystem::remove_all(folder_);
    network_ = test::networkByHand();
    cloud_ = test::cloudByHand(network_);
    cloud_.wkt = utm32();
  }

  void
  TearDown() override
  {
    std::filesystem::remove_all(folder_);
  }

  std::vector<std::string>
  write()
  {
    options_.source = "by_hand.las";
    return writePowerLineFiles(folder_.string(), cloud_, network_, options_);
  }

  std::unique_ptr<GDALDataset>
  open(const char* name)
  {
    return std::unique_ptr<GDALDataset>(GDALDataset::Open(
        (folder_ / name).c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr));
  }

  std::filesystem::path folder_;
  PowerLineNetwork network_;
  io::Cloud cloud_;
  OutputOptions options_;
};

TEST_F(OutputFiles, AreThoseThatAreReturned)
{
  const auto paths = write();
  ASSERT_EQ(paths.size(), std::size(names));
  for (std::size_t i = 0; i < paths.size(); ++i) {
    EXPECT_EQ(std::filesystem::path(paths[i]).filename(), names[i]);
    EXPECT_GT(std::filesystem::file_size(paths[i]), 0U);
  }
}

TEST_F(OutputFiles, ClassifiedCloudKeepsEverythingElse)
{
  write();
  const io::Cloud again = io::readCloud((folder_ / names[0]).string());
  ASSERT_EQ(again.points.size(), cloud_.points.size());
  const auto value = [&](const io::Cloud& cloud, const char* name, std::size_t i) {
    const io::Column* column = cloud.find(name);
    if (column == nullptr)
      throw std::runtime_error(std::string("no column ") + name);
    return io::valueAt(*column, i);
  };
  for (std::size_t i = 0; i < cloud_.points.size(); ++i) {
    SCOPED_TRACE(i);
    const Point world = again.points[i] + again.shift;
    EXPECT_LT((world - cloud_.points[i] - cloud_.shift).norm(), 0.002);
    for (const char* name : {"intensity", "gps_time"})
      EXPECT_EQ(value(again, name, i), value(cloud_, name, i));
    const double given = i < 13 ? 1 : i < 15 ? 5 : 2;
    EXPECT_EQ(value(again, "classification", i), i < 12 ? 14 : i == 12 ? 15 : given);
    EXPECT_EQ(value(again, "wire_id", i), network_.wire_id[i]);
    EXPECT_EQ(value(again, "span_id", i), network_.span_id[i]);
    const double distance = value(again, "wire_distance", i);
    EXPECT_TRUE(i < 12 ? distance == 0.25 : std::isnan(distance));
  }
}

TEST_F(OutputFiles, ClassesOfAnEarlierRunAreReplacedNotRepeated)
{
  classify(cloud_, network_);
  const std::size_t columns = cloud_.columns.size();
  classify(cloud_, network_);
  EXPECT_EQ(cloud_.columns.size(), columns);
}

TEST_F(OutputFiles, LasToLasKeepsIntegersBitForBit)
{
  // The bundled scene through the reader, as a user would run it.
  const std::string path = std::string(LINELET_SOURCE_DIR) + "/data/corridor.las";
  cloud_ = io::readCloud(path);
  PowerLineNetwork empty;
  const std::size_t n = cloud_.points.size();
  empty.classes.assign(n, 0);
  empty.wire_id.assign(n, 0);
  empty.span_id.assign(n, 0);
  empty.wire_distance.assign(n, NAN);
  empty.classes[5] = wire_class;
  network_ = empty;
  write();
  const io::Cloud again = io::readCloud((folder_ / names[0]).string());
  ASSERT_EQ(again.points.size(), n);
  EXPECT_EQ(again.shift, cloud_.shift);
  EXPECT_EQ(again.points, cloud_.points);
  EXPECT_EQ(again.wkt, cloud_.wkt);
  for (const io::Column& column : cloud_.columns) {
    const io::Column* other = again.find(column.name);
    ASSERT_NE(other, nullptr) << column.name;
    for (std::size_t i = 0; i < n; ++i)
      if (column.name != "classification" || i != 5) {
        ASSERT_EQ(io::valueAt(*other, i), io::valueAt(column, i))
            << column.name << " of point " << i;
      }
  }
  EXPECT_EQ(io::valueAt(*again.find("classification"), 5), 14);
}

TEST_F(OutputFiles, LayersOpenInGdalWithGeometryAttributesAndReference)
{
  write();
  const auto file = open("wires.gpkg");
  ASSERT_NE(file, nullptr);
  OGRLayer* wires = file->GetLayerByName("wires");
  OGRLayer* pylons = file->GetLayerByName("pylons");
  ASSERT_NE(wires, nullptr);
  ASSERT_NE(pylons, nullptr);
  EXPECT_EQ(wires->GetFeatureCount(), 3);
  EXPECT_EQ(pylons->GetFeatureCount(), 3);
  ASSERT_NE(wires->GetSpatialRef(), nullptr);
  EXPECT_STREQ(wires->GetSpatialRef()->GetAuthorityCode(nullptr), "25832");
  std::size_t i = 0;
  for (const auto& feature : *wires) {
    const Wire& wire = network_.wires[i++];
    EXPECT_EQ(feature->GetFieldAsInteger("wire_id"), wire.id);
    EXPECT_EQ(feature->GetFieldAsInteger("span_id"), wire.span);
    EXPECT_EQ(feature->GetFieldAsInteger("below_clearance"), wire.id == 2 ? 1 : 0);
    EXPECT_EQ(feature->GetFieldAsDouble("length"), wire.length);
    EXPECT_EQ(feature->GetFieldAsString("reason"), wire.reason);
    const OGRLineString* line = feature->GetGeometryRef()->toLineString();
    ASSERT_GE(line->getNumPoints(), 2);
    OGRPoint first, last;
    line->StartPoint(&first);
    line->EndPoint(&last);
    const Point front = wire.front + cloud_.shift, back = wire.back + cloud_.shift;
    EXPECT_LT((Point(first.getX(), first.getY(), first.getZ()) - front).norm(), 1e-6);
    EXPECT_LT((Point(last.getX(), last.getY(), last.getZ()) - back).norm(), 1e-6);
  }
  const auto drawing = open("wires.dxf");
  ASSERT_NE(drawing, nullptr);
  EXPECT_EQ(drawing->GetLayer(0)->GetFeatureCount(), 12); // each with a text
}

// The scan ends a few meters beyond two poles of the bundled scene: the rest of the
// wires there is short, but as densely covered as elsewhere.
TEST(BundledScene, ShortWiresAtTheBorderAreJudgedByTheirPoints)
{
  const io::Cloud cloud =
      io::readCloud(std::string(LINELET_SOURCE_DIR) + "/data/corridor.las");
  const PowerLineNetwork network = extractPowerLines(cloud);
  std::size_t short_ones = 0;
  for (const Wire& wire : network.wires) {
    EXPECT_EQ(wire.reason.find("points on 0.0 %"), std::string::npos) << wire.id;
    if (wire.length < 10) {
      ++short_ones;
      EXPECT_GT(wire.confidence, 0.5) << wire.id << ": " << wire.reason;
      EXPECT_NE(wire.reason.find("m long"), std::string::npos) << wire.id;
    }
  }
  EXPECT_GT(short_ones, 0U);
}

TEST_F(OutputFiles, ADrawingNamesItsWiresByLayerAndText)
{
  write();
  const auto drawing = open("wires.dxf");
  ASSERT_NE(drawing, nullptr);
  std::size_t wires = 0, texts = 0;
  for (const auto& feature : *drawing->GetLayer(0)) {
    const std::string layer = feature->GetFieldAsString("Layer");
    if (layer.rfind("wires_circuit_", 0) == 0) {
      ++wires;
      EXPECT_EQ(wkbFlatten(feature->GetGeometryRef()->getGeometryType()),
                wkbLineString);
      EXPECT_EQ(feature->GetGeometryRef()->getCoordinateDimension(), 3);
    }
    const std::string text = feature->GetFieldAsString("Text");
    texts += layer == "labels" && text.rfind("wire_id ", 0) == 0;
    if (text.rfind("wire_id 2,", 0) == 0) {
      EXPECT_NE(text.find("vegetation_clearance 3.00"), std::string::npos) << text;
    }
  }
  EXPECT_EQ(wires, 3U);
  EXPECT_EQ(texts, 3U);
}

TEST_F(OutputFiles, GeoJsonIsInDegreesByDefault)
{
  write();
  const auto degrees = nlohmann::json::parse(textOf(folder_ / "wires.geojson"));
  EXPECT_FALSE(degrees.contains("crs"));
  ASSERT_EQ(degrees.at("features").size(), 6U);
  EXPECT_TRUE(
      degrees.at("features")[0].at("properties").at("vegetation_clearance").is_null());
  const auto& place = degrees.at("features")[0].at("geometry").at("coordinates")[0];
  EXPECT_NEAR(place[0].get<double>(), 9.98027028, 1e-8); // by gdaltransform
  EXPECT_NEAR(place[1].get<double>(), 53.51494063, 1e-8);
  EXPECT_NEAR(place[2].get<double>(), 120, 1e-6);

  options_.vectors.keep_crs = true;
  write();
  const auto json = nlohmann::json::parse(textOf(folder_ / "wires.geojson"));
  EXPECT_NE(json.at("crs").dump().find("25832"), std::string::npos);
  ASSERT_EQ(json.at("features").size(), 6U);
  const auto& wire = json.at("features")[0];
  EXPECT_EQ(wire.at("properties").at("layer"), "wires");
  EXPECT_TRUE(wire.at("properties").at("vegetation_clearance").is_null());
  const auto& first = wire.at("geometry").at("coordinates")[0];
  EXPECT_NEAR(first[0].get<double>(), 565000, 1e-6);
  EXPECT_NEAR(first[1].get<double>(), 5930003, 1e-6);
  EXPECT_NEAR(first[2].get<double>(), 120, 1e-6);
}

TEST_F(OutputFiles, SummaryCountsWhatIsThere)
{
  write();
  const auto json = nlohmann::json::parse(textOf(folder_ / "summary.json"));
  EXPECT_EQ(json.at("source"), "by_hand.las");
  EXPECT_EQ(json.at("points"), 55);
  const auto& totals = json.at("totals");
  EXPECT_EQ(totals.at("spans"), 2);
  EXPECT_EQ(totals.at("wires"), 3);
  EXPECT_EQ(totals.at("pylons"), 2);
  EXPECT_EQ(totals.at("poles"), 1);
  EXPECT_EQ(totals.at("wire_points"), 12);
  EXPECT_EQ(totals.at("pylon_points"), 1);
  EXPECT_EQ(totals.at("wires_below_clearance"), 1);
  EXPECT_EQ(totals.at("wires_of_low_confidence"), 1);
  EXPECT_NEAR(
      totals.at("wire_length").get<double>(), 3 * 1600 * std::sinh(50.0 / 800), 1e-3);
  EXPECT_TRUE(json.at("wires")[0].at("vegetation_clearance").is_null());
  EXPECT_EQ(json.at("wires")[1].at("vegetation_clearance").at("distance"), 3);
  EXPECT_EQ(json.at("wires")[1].at("catenary").at("a"), 800);
  EXPECT_EQ(json.at("circuits")[0].at("pylons").size(), 3U);
}

// If nothing was seen below the wires, a count of 0 would be a promise.
TEST_F(OutputFiles, SummaryCountsNoClearancesThatAreUnknown)
{
  EXPECT_EQ(wiresBelowClearance(network_, 5), std::optional<std::size_t>(1));
  for (Wire& wire : network_.wires)
    wire.ground = wire.vegetation = Clearance();
  EXPECT_EQ(wiresBelowClearance(network_, 5), std::nullopt);
  EXPECT_EQ(wiresBelowClearance({}, 5), std::optional<std::size_t>(0));
  write();
  const auto json = nlohmann::json::parse(textOf(folder_ / "summary.json"));
  EXPECT_TRUE(json.at("totals").at("wires_below_clearance").is_null());
}

TEST_F(OutputFiles, TheSameInputGivesTheSameText)
{
  write();
  std::vector<std::string> first;
  for (const char* name : {"wires.geojson", "summary.json", "report.html"})
    first.push_back(textOf(folder_ / name));
  write(); // over the old ones
  std::size_t i = 0;
  for (const char* name : {"wires.geojson", "summary.json", "report.html"})
    EXPECT_EQ(textOf(folder_ / name), first[i++]) << name;
}

TEST_F(OutputFiles, NoWiresGiveValidEmptyFiles)
{
  PowerLineNetwork empty;
  const std::size_t n = cloud_.points.size();
  empty.classes.assign(n, 0);
  empty.wire_id.assign(n, 0);
  empty.span_id.assign(n, 0);
  empty.wire_distance.assign(n, NAN);
  network_ = empty;
  write();
  EXPECT_EQ(io::readCloud((folder_ / names[0]).string()).points.size(), n);
  const auto json = nlohmann::json::parse(textOf(folder_ / "wires.geojson"));
  EXPECT_TRUE(json.at("features").empty());
  const auto file = open("wires.gpkg");
  ASSERT_NE(file, nullptr);
  ASSERT_NE(file->GetLayerByName("wires"), nullptr);
  EXPECT_EQ(file->GetLayerByName("wires")->GetFeatureCount(), 0);
  // A style or script that names a column finds it even in a file without wires.
  const auto columnOf = [&](const char* layer, const char* column) {
    return file->GetLayerByName(layer)->GetLayerDefn()->GetFieldIndex(column);
  };
  for (const char* column : {"wire_id", "length", "ground_clearance", "reason"})
    EXPECT_GE(columnOf("wires", column), 0) << column;
  for (const char* column : {"pylon_id", "kind", "height"})
    EXPECT_GE(columnOf("pylons", column), 0) << column;
  EXPECT_NE(open("wires.dxf"), nullptr);
  const auto summary = nlohmann::json::parse(textOf(folder_ / "summary.json"));
  EXPECT_EQ(summary.at("totals").at("wires"), 0);
  EXPECT_TRUE(summary.at("wires").is_array());
}

TEST_F(OutputFiles, AnEmptyCloudIsNotAnError)
{
  cloud_ = io::Cloud();
  network_ = PowerLineNetwork();
  write();
  EXPECT_EQ(io::readCloud((folder_ / names[0]).string()).points.size(), 0U);
}

TEST_F(OutputFiles, RefuseANetworkOfAnotherCloud)
{
  cloud_.points.pop_back();
  for (io::Column& column : cloud_.columns)
    std::visit([](auto& values) { values.pop_back(); }, column.values);
  EXPECT_THROW(classify(cloud_, network_), std::invalid_argument);
}

TEST_F(OutputFiles, SayWhichFolderCannotBeMade)
{
  std::ofstream(folder_) << "a file where the folder should be";
  try {
    write();
    FAIL() << "no error";
  }
  catch (const io::FileError& error) {
    EXPECT_NE(std::string(error.what()).find(folder_.string()), std::string::npos);
  }
}

} // namespace
