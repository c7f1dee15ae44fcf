// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// What may and may not change when a LAS file is rewritten.

#include <cmath>

#include <linelet/io/point_file.h>

#include "io/file_helpers.h"
#include "test_data.h"

using namespace linelet;
using namespace linelet::io;
using namespace linelet::test;

namespace {

std::size_t
recordLength(const std::string& bytes)
{
  return numberAt<std::uint16_t>(bytes, 105);
}

std::string
record(const std::string& bytes, std::size_t i)
{
  return bytes.substr(numberAt<std::uint32_t>(bytes, 96) + i * recordLength(bytes),
                      recordLength(bytes));
}

/** Offset after the header of the first record of \a user and \a number. */
std::size_t
findRecord(const std::string& bytes, const std::string& user, unsigned number)
{
  std::size_t at = numberAt<std::uint16_t>(bytes, 94);
  for (std::uint32_t i = 0; i < numberAt<std::uint32_t>(bytes, 100); ++i) {
    if (bytes.compare(at + 2, user.size() + 1, user.c_str(), user.size() + 1) == 0 &&
        numberAt<std::uint16_t>(bytes, at + 18) == number)
      return at + 54;
    at += 54U + numberAt<std::uint16_t>(bytes, at + 20);
  }
  return std::string::npos;
}

/** A LAS 1.2 file of format 0 with one point and the given extra bytes. */
std::string
smallFile(const std::string& descriptors, const std::string& extra)
{
  Cloud cloud;
  cloud.points = {{1, 2, 3}};
  const Folder folder;
  writeCloud(folder.file("a.las"), cloud);
  std::string bytes = bytesOf(folder.file("a.las"));
  const std::string point = record(bytes, 0);
  bytes.resize(375);
  const auto put = [&](std::size_t at, auto value) {
    std::memcpy(&bytes[at], &value, sizeof value);
  };
  std::string head(54, '\0');
  head.replace(2, 9, "LASF_Spec");
  head[18] = 4;
  const auto size = static_cast<std::uint16_t>(descriptors.size());
  std::memcpy(&head[20], &size, 2);
  put(96, static_cast<std::uint32_t>(375 + 54 + descriptors.size()));
  put(100, std::uint32_t{1});
  put(105, static_cast<std::uint16_t>(20 + extra.size()));
  return bytes + head + descriptors + point + extra;
}

template <class T>
std::string
raw(T value)
{
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string
descriptor(int type, const std::string& name, int options, double scale, double offset)
{
  std::string text(192, '\0');
  text[2] = static_cast<char>(type);
  text[3] = static_cast<char>(options);
  text.replace(4, name.size(), name);
  for (std::size_t i = 0; i < 3; ++i) {
    text.replace(112 + 8 * i, 8, raw(scale));
    text.replace(136 + 8 * i, 8, raw(offset));
  }
  return text;
}

} // namespace

TEST(LasDetails, AChangedClassAndANewColumnLeaveTheRestBitForBit)
{
  LINELET_NEEDS_DATA("readers/las");
  const Folder folder;
  for (const char* name : {"pdal_extrabytes.las",
                           "laspy_1_4_w_evlr.las",
                           "laspy_simple1_3.las",
                           "laspy_unregistered_extra_bytes.las",
                           "pdal_perm_1.0_1.las",
                           "loadersgl_pdrf10-1.4.las"}) {
    SCOPED_TRACE(name);
    const std::string before = bytesOf(dataPath("readers/las") / name);
    Cloud cloud = readCloud(dataPath("readers/las") / name);
    const std::size_t count = cloud.points.size();
    cloud.set({"classification", std::vector<std::uint8_t>(count, 14), {}});
    std::vector<float> values;
    for (std::size_t i = 0; i < count; ++i)
      values.push_back(static_cast<float>(i) / 3);
    cloud.set({"linearity", values, "shape of the neighborhood"});
    writeCloud(folder.file("out.las"), cloud);
    const std::string after = bytesOf(folder.file("out.las"));

    EXPECT_EQ(after[104], before[104]); // point format
    EXPECT_EQ(after[25], before[25]);   // version
    ASSERT_EQ(recordLength(after), recordLength(before) + 4);
    const bool old = before[104] < 6;
    for (std::size_t i = 0; i < count; ++i) {
      std::string expected = record(before, i) + raw(values[i]);
      char& byte = expected[old ? 15 : 16];
      byte = static_cast<char>(old ? (byte & 0xE0) | 14 : 14);
      ASSERT_TRUE(record(after, i) == expected) << i;
    }
    const Cloud again = readCloud(folder.file("out.las"));
    ASSERT_NE(again.find("linearity"), nullptr);
    EXPECT_EQ(again.find("linearity")->values, Values(values));
    EXPECT_EQ(again.find("linearity")->description, "shape of the neighborhood");
    EXPECT_EQ(again.wkt, cloud.wkt);
  }
}

TEST(LasDetails, RecordsBeforeAndBehindThePointsAreKept)
{
  LINELET_NEEDS_DATA("readers/las/laspy_1_4_w_evlr.las");
  const Folder folder;
  for (const char* name : {"laspy_1_4_w_evlr.las", "laspy_simple1_4.las"}) {
    const std::string before = bytesOf(dataPath("readers/las") / name);
    writeCloud(folder.file("out.las"), readCloud(dataPath("readers/las") / name));
    const std::string after = bytesOf(folder.file("out.las"));
    const std::size_t first = numberAt<std::uint32_t>(before, 96);
    EXPECT_TRUE(before.substr(375, first - 375) == after.substr(375, first - 375));
    const std::size_t place = numberAt<std::uint64_t>(before, 235);
    ASSERT_EQ(numberAt<std::uint64_t>(after, 235), place);
    EXPECT_EQ(numberAt<std::uint32_t>(after, 243),
              numberAt<std::uint32_t>(before, 243));
    EXPECT_TRUE(before.substr(place) == after.substr(place));
  }
}

TEST(LasDetails, WaveformsMoveWithTheirPlaceInTheHeader)
{
  LINELET_NEEDS_DATA("readers/las/laspy_simple1_3.las");
  const Folder folder;
  const std::string before = bytesOf(dataPath("readers/las/laspy_simple1_3.las"));
  Cloud cloud = readCloud(dataPath("readers/las/laspy_simple1_3.las"));
  cloud.set({"id", std::vector<std::int32_t>(cloud.points.size(), 5), {}});
  writeCloud(folder.file("out.las"), cloud);
  const std::string after = bytesOf(folder.file("out.las"));
  const std::size_t from = numberAt<std::uint64_t>(before, 227);
  const std::size_t to = numberAt<std::uint64_t>(after, 227);
  EXPECT_NE(from, to);
  EXPECT_TRUE(before.substr(from) == after.substr(to));
}

TEST(LasDetails, ScaledExtraBytesAreUnderstoodAndKeptRaw)
{
  const Folder folder;
  const std::int64_t large = (std::int64_t{1} << 60) + 1; // no double
  const std::string bytes = smallFile(
      descriptor(4, "height", 24, 0.01, 100) + descriptor(8, "large", 8, 0.1, 0) +
          descriptor(22, "triple", 0, 0, 0) + descriptor(0, "hidden", 2, 0, 0),
      raw(std::int16_t{-250}) + raw(large) + std::string("\x01\xFF\x03", 3) + "ab");
  writeBytes(folder.file("in.las"), bytes);
  Cloud cloud = readCloud(folder.file("in.las"));
  EXPECT_DOUBLE_EQ(valueAt(*cloud.find("height"), 0), 97.5);
  EXPECT_DOUBLE_EQ(valueAt(*cloud.find("large"), 0), 0.1 * 0x1p60);
  EXPECT_EQ(valueAt(*cloud.find("triple_1"), 0), -1);
  writeCloud(folder.file("out.las"), cloud);
  EXPECT_TRUE(record(bytesOf(folder.file("out.las")), 0) == record(bytes, 0));

  // A changed value is stored in steps of its scale.
  cloud.set({"height", std::vector<double>{98.25}, {}});
  writeCloud(folder.file("out.las"), cloud);
  std::string expected = record(bytes, 0);
  expected.replace(20, 2, raw(std::int16_t{-175}));
  EXPECT_TRUE(record(bytesOf(folder.file("out.las")), 0) == expected);
}

TEST(LasDetails, NamesTakenOrMissingAreMadeUnique)
{
  const Folder folder;
  writeBytes(folder.file("in.las"),
             smallFile(descriptor(1, "intensity", 0, 0, 0) +
                           descriptor(1, "", 0, 0, 0) + descriptor(1, "", 0, 0, 0) +
                           descriptor(1, "a\xFF", 0, 0, 0),
                       "abcd"));
  const Cloud cloud = readCloud(folder.file("in.las"));
  EXPECT_EQ(valueAt(*cloud.find("intensity_2"), 0), 'a');
  EXPECT_EQ(valueAt(*cloud.find("extra"), 0), 'b');
  EXPECT_EQ(valueAt(*cloud.find("extra_2"), 0), 'c');
  EXPECT_EQ(valueAt(*cloud.find("a_"), 0), 'd'); // no UTF-8
}

TEST(LasDetails, AClassBeyond31MakesANewFormatOfLas14)
{
  LINELET_NEEDS_DATA("readers/las/pdal_autzen-point-format-3.las");
  const Folder folder;
  Cloud cloud = readCloud(dataPath("readers/las/pdal_autzen-point-format-3.las"));
  const std::size_t count = cloud.points.size();
  cloud.set({"classification", std::vector<std::uint8_t>(count, 64), {}});
  std::vector<std::string> warnings;
  writeCloud(folder.file("out.las"), cloud, {}, &warnings);
  EXPECT_EQ(warnings.size(), 1U);
  const std::string after = bytesOf(folder.file("out.las"));
  EXPECT_EQ(after[104], 7);
  EXPECT_EQ(after[25], 4);
  EXPECT_EQ(numberAt<std::uint16_t>(after, 6) & 16, 16); // WKT
  EXPECT_NE(findRecord(after, "LASF_Projection", 2112), std::string::npos);
  const Cloud again = readCloud(folder.file("out.las"));
  EXPECT_EQ(again.wkt, cloud.wkt);
  for (const Column& column : cloud.columns)
    for (std::size_t i = 0; i < count; ++i)
      ASSERT_NEAR(valueAt(*again.find(column.name), i), valueAt(column, i), 0.0031)
          << column.name; // angles in steps of 0.006
}

TEST(LasDetails, HeaderSaysCountsReturnsAndBounds)
{
  const Folder folder;
  Cloud cloud;
  cloud.shift = {500000, 5000000, 100};
  cloud.points = {{0.25, 1, -3}, {-2, 7.125, 4}, {1, 1, 1}};
  cloud.set({"return_number", std::vector<std::uint8_t>{1, 2, 2}, {}});
  writeCloud(folder.file("a.las"), cloud);
  const std::string bytes = bytesOf(folder.file("a.las"));
  EXPECT_EQ(numberAt<std::uint64_t>(bytes, 247), 3U);
  EXPECT_EQ(numberAt<std::uint32_t>(bytes, 107), 3U);
  EXPECT_EQ(numberAt<std::uint64_t>(bytes, 255), 1U);
  EXPECT_EQ(numberAt<std::uint64_t>(bytes, 263), 2U);
  EXPECT_EQ(numberAt<double>(bytes, 179), 500001);
  EXPECT_EQ(numberAt<double>(bytes, 187), 499998);
  EXPECT_EQ(numberAt<double>(bytes, 195), 5000007.125);
  EXPECT_EQ(numberAt<double>(bytes, 219), 97);
}

TEST(LasDetails, ReferenceSystemsAreFoundInKeysAndText)
{
  LINELET_NEEDS_DATA("readers/las");
  const auto nameOf = [](const char* file) {
    return referenceName(readCloud(dataPath("readers/las") / file).wkt);
  };
  EXPECT_EQ(nameOf("pdal_utm15.las"), "NAD83 / UTM zone 15N"); // GeoTIFF keys
  EXPECT_EQ(nameOf("pdal_test_epsg_4326_axis.las"), "WGS 84");
  EXPECT_NE(nameOf("pdal_test1_4.las"), ""); // WKT
  EXPECT_EQ(nameOf("pdal_100-points.las"), "");
}

TEST(LasDetails, AWriteThatFailsLeavesNothing)
{
  Cloud cloud;
  cloud.points.assign(100000, Point(1, 2, 3));
  EXPECT_THROW(writeCloud("/dev/full", cloud), FileError); // no ending
  const Folder folder;
  std::filesystem::create_symlink("/dev/full", folder.file("full.las"));
  for (const std::string& path : {folder.file("none/a.las"),
                                  folder.file("full.las"),
                                  std::string("/dev/null/a.las")})
    try {
      writeCloud(path, cloud);
      ADD_FAILURE() << path;
    }
    catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find("cannot be written"), std::string::npos);
    }
  std::size_t entries = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    entries += entry.is_symlink() ? 0 : 1;
  EXPECT_EQ(entries, 0U);
}
