// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Every file of the reference data is read completely or refused in one line.

#include <algorithm>
#include <map>
#include <sstream>

#include <linelet/io/point_file.h>

#include "file_helpers.h"
#include "test_data.h"

using namespace linelet::io;
using namespace linelet::test;

namespace fs = std::filesystem;

namespace {

/** The error message, checked for what every message must have; "" if the file is
 * read. */
std::string
refusal(const fs::path& path, bool lenient = false)
{
  ReadOptions options;
  options.lenient = lenient;
  try {
    readCloud(path, options);
    return {};
  }
  catch (const FileError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(message.rfind(path.string() + ": ", 0), 0U) << message;
    EXPECT_GT(message.size(), path.string().size() + 10);
    return message;
  }
}

/** Number of points read leniently; a loss must be reported. */
std::size_t
lenientPoints(const fs::path& path)
{
  std::vector<std::string> warnings;
  ReadOptions options;
  options.lenient = true;
  const std::size_t count = readCloud(path, options, &warnings).points.size();
  EXPECT_TRUE(
      std::any_of(warnings.begin(), warnings.end(), [](const std::string& text) {
        return text.find("ends") != std::string::npos;
      }));
  return count;
}

/** Lines with at least three numbers, counted without the library. */
std::size_t
countRows(const std::string& text)
{
  std::istringstream lines(text);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    double x = 0, y = 0, z = 0;
    count += words >> x >> y >> z ? 1U : 0U;
  }
  return count;
}

/** The number after \a key in a header. */
std::size_t
statedCount(const std::string& bytes, const std::string& key)
{
  return std::stoul(bytes.substr(bytes.find(key) + key.size()));
}

} // namespace

TEST(ReaderFiles, BrokenLasIsRefusedSayingWhy)
{
  LINELET_NEEDS_DATA("readers/las_broken");
  const std::map<std::string, std::string> reasons = {
      {"bad_magic.las", "LASF"},
      {"compressed_bit_on_raw.las", "laszip"},
      {"empty_0byte.las", "empty"},
      {"fmt_99.las", "point format 99"},
      {"header_only_no_points_data.las", "before the points"},
      {"huge_point_count.las", "4294967295 points"},
      {"offset_beyond_eof.las", "before the points at byte 2147483647"},
      {"only_magic.las", "within the header"},
      {"rec_len_0.las", "record length 0"},
      {"rec_len_too_small.las", "record length 10"},
      {"scale_nan.las", "scale factor of x is nan"},
      {"scale_zero.las", "scale factor of x is 0"},
      {"trunc_1_4_after_header.las", "after 400 bytes"},
      {"trunc_1_4_in_evlr.las", "after 999 whole ones"},
      {"trunc_in_header_100B.las", "within the header"},
      {"trunc_in_vlr.las", "after 3000 bytes"},
      {"trunc_mid_point_record.las", "after 581 whole ones"},
      {"version_9_9.las", "version 9.9"}};
  std::size_t refused = 0;
  for (const auto& entry : fs::directory_iterator(dataPath("readers/las_broken"))) {
    const std::string name = entry.path().filename();
    SCOPED_TRACE(name);
    const std::string message = refusal(entry.path());
    if (name == "vlr_count_huge.las") {
      EXPECT_EQ(message, ""); // its points are whole
      continue;
    }
    ASSERT_EQ(reasons.count(name), 1U);
    EXPECT_NE(message.find(reasons.at(name)), std::string::npos) << message;
    ++refused;
  }
  EXPECT_EQ(refused, reasons.size());
}

TEST(ReaderFiles, LenientReadsWhatIsWholeOfCutLas)
{
  LINELET_NEEDS_DATA("readers/las_broken");
  const fs::path folder = dataPath("readers/las_broken");
  // (20000 - 229) / 34 and (32300 - 2305) / 30, whole
  EXPECT_EQ(lenientPoints(folder / "trunc_mid_point_record.las"), 581U);
  EXPECT_EQ(lenientPoints(folder / "trunc_1_4_in_evlr.las"), 999U);
  EXPECT_EQ(lenientPoints(folder / "huge_point_count.las"), 1065U);
  EXPECT_EQ(lenientPoints(folder / "trunc_in_vlr.las"), 0U);
  EXPECT_NE(refusal(folder / "trunc_in_header_100B.las", true), "");
  EXPECT_NE(refusal(folder / "scale_nan.las", true), "");
}

TEST(ReaderFiles, LazUnderTheNameOfLasIsReadAlike)
{
  LINELET_NEEDS_DATA("readers/las/laspy_simple.laz");
  const Folder folder;
  fs::copy_file(dataPath("readers/las/laspy_simple.laz"), folder.file("a.las"));
  EXPECT_EQ(readCloud(folder.file("a.las")).points.size(), 1065U);
}

TEST(ReaderFiles, TablesHoldTheirPoints)
{
  LINELET_NEEDS_DATA("readers/other");
  const std::map<std::string, std::string> refused = {
      {"pdal_missingheader.pcd", "DATA"},
      {"pdal_badheader.txt", "'z'"},
      {"pdal_sized_dims.ply", "'z'"},
      {"pdal_unsized_dims.ply", "'z'"}};
  for (const auto& entry : fs::directory_iterator(dataPath("readers/other"))) {
    const fs::path& path = entry.path();
    SCOPED_TRACE(path.filename());
    const std::string message = refusal(path);
    if (refused.count(path.filename()) != 0) {
      EXPECT_NE(message.find(refused.at(path.filename())), std::string::npos)
          << message;
      continue;
    }
    ASSERT_EQ(message, "");
    const std::string bytes = bytesOf(path);
    const std::size_t expected =
        path.extension() == ".pcd"   ? statedCount(bytes, "\nPOINTS ")
        : path.extension() == ".ply" ? statedCount(bytes, "\nelement vertex ")
                                     : countRows(bytes);
    EXPECT_EQ(readCloud(path).points.size(), expected);
  }
}

TEST(ReaderFiles, CompressedPcdUnpacksToPlacesInItsRegion)
{
  LINELET_NEEDS_DATA("readers/other/pcldata_terrain_samp11-utm.pcd");
  const Cloud cloud =
      readCloud(dataPath("readers/other/pcldata_terrain_samp11-utm.pcd"));
  ASSERT_EQ(cloud.points.size(), 38010U);
  // Neighbors in the file are neighbors on the ground if the fields are in order.
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    ASSERT_LT((cloud.points[i] - cloud.points[0]).norm(), 2000);
}

TEST(ReaderFiles, NamesOfOtherSoftwareMeanTheSame)
{
  LINELET_NEEDS_DATA("readers/other");
  const Cloud pdal = readCloud(dataPath("readers/other/pdal_autzen-utm.pcd"));
  for (const char* name :
       {"intensity", "return_number", "gps_time", "scan_angle", "red"})
    EXPECT_NE(pdal.find(name), nullptr) << name;
  const Cloud quoted = readCloud(dataPath("readers/other/pdal_largescan.txt"));
  EXPECT_NE(quoted.find("OffsetTime"), nullptr);
  EXPECT_NE(quoted.find("scan_angle"), nullptr);
  // 4.2108e+06 as the bits of a float: gray 128, 128, 96
  const Cloud packed = readCloud(dataPath("readers/other/loadersgl_simple-ascii.pcd"));
  ASSERT_NE(packed.find("red"), nullptr);
  EXPECT_EQ(valueAt(*packed.find("red"), 0), 128);
}
