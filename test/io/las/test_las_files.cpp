// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Real LAS files: their content is read, and written back bit for bit.

#include <algorithm>
#include <optional>
#include <vector>

#include <linelet/io/point_file.h>

#include "io/file_helpers.h"
#include "test_data.h"

using namespace linelet;
using namespace linelet::io;
using namespace linelet::test;

namespace fs = std::filesystem;

namespace {

/** The content of a LAS header, read here without the library. */
struct Header {
  int minor, format;
  std::size_t points_at, record_length, count;

  explicit Header(const std::string& bytes)
      : minor(bytes[25]),
        format(static_cast<unsigned char>(bytes[104])),
        points_at(numberAt<std::uint32_t>(bytes, 96)),
        record_length(numberAt<std::uint16_t>(bytes, 105)),
        count(numberAt<std::uint32_t>(bytes, 107))
  {
    if (minor >= 4)
      count = numberAt<std::uint64_t>(bytes, 247);
  }

  std::string
  records(const std::string& bytes) const
  {
    return bytes.substr(points_at, count * record_length);
  }
};

std::vector<fs::path>
filesIn(const std::string& folder, const std::string& ending)
{
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(dataPath(folder)))
    if (entry.path().extension() == ending)
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/** Files that end before their header says. */
bool
isCut(const fs::path& path)
{
  return path.filename() == "pdal_garbage_nVariableLength.las" ||
         path.filename() == "pdal_perm_1.2-no-points.las";
}

void
expectSameRecords(const std::string& before, const std::string& after)
{
  const Header a(before), b(after);
  EXPECT_EQ(a.format, b.format);
  EXPECT_EQ(a.minor, b.minor);
  EXPECT_EQ(a.record_length, b.record_length);
  EXPECT_EQ(a.count, b.count);
  EXPECT_TRUE(a.records(before) == b.records(after)) << "point records differ";
}

} // namespace

TEST(LasFiles, EveryFileIsReadWithAsManyPointsAsItHolds)
{
  LINELET_NEEDS_DATA("readers/las");
  for (const fs::path& path : filesIn("readers/las", ".las")) {
    SCOPED_TRACE(path.filename());
    if (isCut(path)) {
      EXPECT_THROW(readCloud(path), FileError);
      continue;
    }
    EXPECT_EQ(readCloud(path).points.size(), Header(bytesOf(path)).count);
  }
}

TEST(LasFiles, WritingWhatWasReadKeepsEveryPointRecordBitForBit)
{
  LINELET_NEEDS_DATA("readers/las");
  const Folder folder;
  std::vector<fs::path> files = filesIn("readers/las", ".las");
  for (const fs::path& path : filesIn("lidar", ".las"))
    if (fs::file_size(path) < 8'000'000)
      files.push_back(path);
  for (const fs::path& path : files) {
    SCOPED_TRACE(path.filename());
    if (isCut(path))
      continue;
    writeCloud(folder.file("out.las"), readCloud(path));
    expectSameRecords(bytesOf(path), bytesOf(folder.file("out.las")));
  }
}

TEST(LasFiles, CoordinatesAreScaleTimesIntegerPlusOffset)
{
  LINELET_NEEDS_DATA("readers/las");
  for (const fs::path& path : filesIn("readers/las", ".las")) {
    SCOPED_TRACE(path.filename());
    if (isCut(path))
      continue;
    const Cloud cloud = readCloud(path);
    const std::string bytes = bytesOf(path);
    const Header header(bytes);
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto steps = numberAt<std::int32_t>(
            bytes, header.points_at + i * header.record_length + 4 * axis);
        const double scale = numberAt<double>(bytes, 131 + 8 * axis);
        const double offset = numberAt<double>(bytes, 155 + 8 * axis);
        const double expected = steps * scale + offset;
        const auto a = static_cast<int>(axis);
        // Two roundings at the magnitude of the coordinate, no more.
        const double rounding =
            4e-16 * (std::abs(expected) + std::abs(offset) + std::abs(cloud.shift[a]) +
                     std::abs(steps * scale));
        ASSERT_NEAR(cloud.shift[a] + cloud.points[i][a], expected, rounding);
      }
  }
}
