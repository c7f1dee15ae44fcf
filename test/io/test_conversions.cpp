// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Whatever two formats can both hold survives the round trip.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <linelet/io/point_file.h>

#include "file_helpers.h"
#include "test_data.h"

using namespace linelet;
using namespace linelet::io;
using namespace linelet::test;

namespace {

Point
world(const Cloud& cloud, std::size_t i)
{
  return cloud.shift + cloud.points[i];
}

void
expectSamePlaces(const Cloud& a, const Cloud& b, double tolerance)
{
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i)
    ASSERT_LE((world(a, i) - world(b, i)).cwiseAbs().maxCoeff(), tolerance) << i;
}

/** Every value of every column of \a a is in \a b, exactly, with NaN for NaN. Text has
 * as many digits as distinguish a float from its neighbors. */
void
expectSameValues(const Cloud& a, const Cloud& b)
{
  for (const Column& column : a.columns) {
    const Column* other = b.find(column.name);
    ASSERT_NE(other, nullptr) << column.name;
    for (std::size_t i = 0; i < a.points.size(); ++i) {
      const double x = valueAt(column, i);
      double y = valueAt(*other, i);
      if (std::holds_alternative<std::vector<float>>(column.values))
        y = static_cast<float>(y);
      ASSERT_TRUE(x == y || (std::isnan(x) && std::isnan(y)))
          << column.name << " of point " << i << ": " << x << " became " << y;
    }
  }
}

/** Near UTM coordinates, on a grid of millimeters, with a column of every type. */
Cloud
exampleCloud()
{
  Cloud cloud;
  cloud.shift = {689000, 5527000, 0};
  const std::size_t count = 20000; // more than two blocks
  for (std::size_t i = 0; i < count; ++i)
    cloud.points.emplace_back(static_cast<double>(i * 37 % 100000) / 1000,
                              static_cast<double>(i * 91 % 100000) / 1000,
                              static_cast<double>(i % 977) / 1000);
  const auto fill = [&](const char* name, auto value) {
    std::vector<decltype(value(std::size_t{}))> values;
    for (std::size_t i = 0; i < count; ++i)
      values.push_back(value(i));
    cloud.set({name, values, {}});
  };
  fill("intensity", [](std::size_t i) { return static_cast<std::uint16_t>(i * 7); });
  fill("classification",
       [](std::size_t i) { return static_cast<std::uint8_t>(i % 19); });
  fill("return_number", [](std::size_t i) { return static_cast<std::uint8_t>(i % 5); });
  fill("scan_angle", [](std::size_t i) {
    return static_cast<float>(0.006 * (static_cast<double>(i % 9000) - 4500));
  });
  fill("gps_time", [](std::size_t i) { return 2.5e8 + 1e-6 * static_cast<double>(i); });
  fill("red", [](std::size_t i) { return static_cast<std::uint8_t>(i); });
  fill("green", [](std::size_t i) { return static_cast<std::uint8_t>(i >> 3); });
  fill("blue", [](std::size_t i) { return static_cast<std::uint8_t>(i >> 6); });
  fill("a8", [](std::size_t i) { return static_cast<std::int8_t>(i); });
  fill("a16", [](std::size_t i) { return static_cast<std::int16_t>(i * 3); });
  fill("a32", [](std::size_t i) { return static_cast<std::int32_t>(i * 100003); });
  fill("u32", [](std::size_t i) { return static_cast<std::uint32_t>(i * 200003); });
  fill("linearity", [](std::size_t i) {
    return i % 11 == 0 ? NAN : 1.0F / static_cast<float>(i + 1);
  });
  fill("lambda", [](std::size_t i) { return 1.0 / static_cast<double>(i + 3); });
  return cloud;
}

void
expectWarningsAbout(const std::vector<std::string>& warnings, const std::string& what)
{
  for (const std::string& warning : warnings)
    EXPECT_NE(warning.find(what), std::string::npos) << warning;
}

} // namespace

class RoundTrip : public testing::TestWithParam<const char*> {};

TEST_P(RoundTrip, KeepsPlacesAndValues)
{
  const Folder folder;
  const Cloud before = exampleCloud();
  const std::string file = folder.file(std::string("cloud.") + GetParam());
  writeCloud(file, before);
  const Cloud after = readCloud(file);
  expectSamePlaces(before, after, 2e-9);
  Cloud expected = before;
  if (std::string(GetParam()) == "las")
    for (const char* name : {"red", "green", "blue"}) {
      // LAS requires 16 bit colors.
      std::vector<std::uint16_t> wide;
      for (std::size_t i = 0; i < before.points.size(); ++i)
        wide.push_back(
            static_cast<std::uint16_t>(256 * valueAt(*before.find(name), i)));
      expected.set({name, wide, {}});
    }
  expectSameValues(expected, after);
}

TEST_P(RoundTrip, KeepsAllAttributesOfLas)
{
  LINELET_NEEDS_DATA("readers/las");
  const Folder folder;
  for (const char* name : {"pdal_autzen-point-format-3.las",
                           "pdal_extrabytes.las",
                           "laspy_1_4_w_evlr.las",
                           "loadersgl_pdrf8-1.4.las",
                           "laspy_simple1_3.las"}) {
    SCOPED_TRACE(name);
    const Cloud before = readCloud(dataPath("readers/las") / name);
    const std::string file = folder.file(std::string("cloud.") + GetParam());
    writeCloud(file, before);
    writeCloud(folder.file("back.las"), readCloud(file));
    const Cloud after = readCloud(folder.file("back.las"));
    // A grid of 1.16e-6 is not recognized; the next one has steps of 1e-6.
    const bool odd = std::string(name) == "laspy_1_4_w_evlr.las";
    expectSamePlaces(before, after, odd ? 5.1e-7 : 5e-9);
    expectSameValues(before, after);
  }
}

TEST_P(RoundTrip, OfAnEmptyCloudIsEmpty)
{
  const Folder folder;
  Cloud cloud;
  cloud.set({"linearity", std::vector<float>(), {}});
  const std::string file = folder.file(std::string("cloud.") + GetParam());
  writeCloud(file, cloud);
  const Cloud after = readCloud(file);
  EXPECT_EQ(after.points.size(), 0U);
  EXPECT_NE(after.find("linearity"), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Formats,
                         RoundTrip,
                         testing::Values("las", "pcd", "ply", "csv", "txt", "xyz"),
                         [](const auto& parameter) { return parameter.param; });

TEST(Conversion, PclReadsCoordinatesThatFitFloats)
{
  const Folder folder;
  Cloud cloud;
  cloud.points = {{1.5, -2.25, 100.125}, {0, 0, 0}};
  std::vector<std::string> warnings;
  writeCloud(folder.file("a.pcd"), cloud, {}, &warnings);
  EXPECT_NE(bytesOf(folder.file("a.pcd")).find("SIZE 4 4 4\n"), std::string::npos);
  EXPECT_TRUE(warnings.empty());
  cloud.shift = {689000.125, 5527000, 0};
  writeCloud(folder.file("a.pcd"), cloud, {}, &warnings);
  EXPECT_NE(bytesOf(folder.file("a.pcd")).find("SIZE 8 8 8\n"), std::string::npos);
  EXPECT_EQ(warnings.size(), 1U);
  expectWarningsAbout(warnings, "8 bytes");
}

TEST(Conversion, AShiftedFileIsReadByPclAndKeepsItsPlace)
{
  const Folder folder;
  Cloud cloud;
  cloud.shift = {689000.125, 5527000.0625, 0.1};
  cloud.points = {{1.5, -2.25, 100.125}, {0, 0, 0}};
  WriteOptions shifted;
  shifted.shifted = true;
  for (const char* name : {"a.pcd", "a.ply", "a.csv", "a.xyz"}) {
    const std::string file = folder.file(name);
    std::vector<std::string> warnings;
    writeCloud(file, cloud, shifted, &warnings);
    EXPECT_TRUE(warnings.empty()) << name;
    EXPECT_EQ(bytesOf(file + ".shift"), "689000.125 5527000.0625 0.1\n");
    expectSamePlaces(cloud, readCloud(file), 0);

    // Useless for the file that replaces it.
    writeCloud(file, cloud);
    EXPECT_FALSE(std::filesystem::exists(file + ".shift")) << name;
    expectSamePlaces(cloud, readCloud(file), 0);
  }
  writeCloud(folder.file("a.pcd"), cloud, shifted);
  EXPECT_NE(bytesOf(folder.file("a.pcd")).find("SIZE 4 4 4\n"), std::string::npos);
  EXPECT_THROW(writeCloud(folder.file("a.las"), cloud, shifted), FileError);
  for (const char* nonsense : {"", "1 2", "1 2 3 4", "1 2 nan", "1 2 x"}) {
    std::ofstream(folder.file("a.pcd") + ".shift") << nonsense;
    EXPECT_THROW(readCloud(folder.file("a.pcd")), FileError) << nonsense;
  }
}

// As CloudCompare writes scalar fields, and names them after reading them.
TEST(Conversion, NamesOfAttributesInPlyAreThoseOfScalarFields)
{
  const Folder folder;
  Cloud cloud;
  cloud.points = {{1, 2, 3}, {4, 5, 6}};
  const std::vector<float> values = {0.25F, 0.5F};
  for (const char* name : {"linearity", "optimal_radius", "normal_x", "intensity"})
    cloud.set({name, values, {}});
  cloud.set({"red", std::vector<std::uint8_t>{1, 2}, {}});
  cloud.set({"green", std::vector<std::uint8_t>{1, 2}, {}});
  cloud.set({"blue", std::vector<std::uint8_t>{1, 2}, {}});
  writeCloud(folder.file("a.ply"), cloud);
  const std::string header = bytesOf(folder.file("a.ply"));
  for (const char* property : {" scalar_linearity\n",
                               " scalar_optimal_radius\n",
                               " nx\n",
                               " intensity\n",
                               " red\n"})
    EXPECT_NE(header.find(property), std::string::npos) << property;
  const Cloud back = readCloud(folder.file("a.ply"));
  ASSERT_EQ(back.columns.size(), cloud.columns.size());
  for (const Column& column : cloud.columns) {
    ASSERT_NE(back.find(column.name), nullptr) << column.name;
    EXPECT_EQ(valueAt(*back.find(column.name), 1), valueAt(column, 1));
  }
}

TEST(Conversion, MillimetersOfSmallCoordinatesSurviveFloats)
{
  const Folder folder;
  Cloud cloud;
  cloud.points = {{123.456, -87.001, 0.003}, {512.9, 7.77, 1.5}};
  writeCloud(folder.file("a.pcd"), cloud);
  EXPECT_NE(bytesOf(folder.file("a.pcd")).find("SIZE 4 4 4\n"), std::string::npos);
  writeCloud(folder.file("a.las"), readCloud(folder.file("a.pcd")));
  expectSamePlaces(cloud, readCloud(folder.file("a.las")), 1e-12);
  writeCloud(folder.file("a.csv"), readCloud(folder.file("a.pcd")));
  EXPECT_EQ(bytesOf(folder.file("a.csv")),
            "x,y,z\n123.456,-87.001,0.003\n512.900,7.770,1.500\n");
}

TEST(Conversion, PointsWithoutCoordinatesSurviveExceptInLas)
{
  const Folder folder;
  Cloud cloud;
  cloud.points = {{1, 2, 3}, {NAN, NAN, NAN}, {4, 5, 6}};
  cloud.set({"id", std::vector<std::int32_t>{10, 20, 30}, {}});
  for (const char* name : {"a.pcd", "a.ply", "a.csv"}) {
    writeCloud(folder.file(name), cloud);
    const Cloud after = readCloud(folder.file(name));
    ASSERT_EQ(after.points.size(), 3U);
    EXPECT_TRUE(std::isnan(after.points[1].x()));
    EXPECT_EQ(after.points[2].x() + after.shift.x(), 4);
  }
  std::vector<std::string> warnings;
  writeCloud(folder.file("a.las"), cloud, {}, &warnings);
  const Cloud after = readCloud(folder.file("a.las"));
  ASSERT_EQ(after.points.size(), 2U);
  EXPECT_EQ(valueAt(*after.find("id"), 1), 30);
  EXPECT_EQ(warnings.size(), 1U);
}

TEST(Conversion, AnAttributeThatLasRoundsIsExactInExtraBytes)
{
  const Folder folder;
  Cloud cloud;
  cloud.points = {{1, 2, 3}, {4, 5, 6}};
  cloud.set({"intensity", std::vector<float>{0.25F, 7.5F}, {}});
  std::vector<std::string> warnings;
  writeCloud(folder.file("a.las"), cloud, {}, &warnings);
  expectWarningsAbout(warnings, "rounded");
  EXPECT_EQ(warnings.size(), 1U);
  const Cloud after = readCloud(folder.file("a.las"));
  EXPECT_EQ(valueAt(*after.find("intensity"), 1), 8);
  EXPECT_EQ(valueAt(*after.find("intensity_2"), 0), 0.25);
}

TEST(Conversion, LargeCloudsGetAGridThatReachesThem)
{
  const Folder folder;
  Cloud cloud;
  cloud.points = {{-6e6, 0, 0}, {6e6, 0.5, 1}};
  writeCloud(folder.file("a.las"), cloud);
  expectSamePlaces(cloud, readCloud(folder.file("a.las")), 0.01);
}

TEST(Conversion, FloatsTooCoarseForTheirPlaceAreWarnedOf)
{
  const Folder folder;
  const auto warningsOf = [&](const std::string& bytes, const std::string& rows) {
    std::string sizes, types;
    for (int axis = 0; axis < 3; ++axis)
      sizes += " " + bytes, types += " F";
    writeBytes(folder.file("a.pcd"),
               "FIELDS x y z\nSIZE" + sizes + "\nTYPE" + types +
                   "\nWIDTH 2\nHEIGHT 1\nDATA ascii\n" + rows);
    std::vector<std::string> warnings;
    readCloud(folder.file("a.pcd"), {}, &warnings);
    return warnings;
  };
  const std::string utm = "500000 5427000.3 200\n500090 5427001.9 210\n";
  const auto warnings = warningsOf("4", utm);
  ASSERT_EQ(warnings.size(), 1U);
  // Between 2^22 and 2^23 floats of 24 bits lie half a unit apart.
  EXPECT_NE(warnings[0].find(" 0.5 apart"), std::string::npos) << warnings[0];
  EXPECT_TRUE(warningsOf("8", utm).empty());
  EXPECT_TRUE(warningsOf("4", "-60 0.25 200\n90 1.9 210\n").empty());
  EXPECT_TRUE(warningsOf("4", "0 0 0\n9000000 5427001 210\n").empty());
  EXPECT_TRUE(warningsOf("4", "500000 1 1\n500000 1 1\n").empty());
}
