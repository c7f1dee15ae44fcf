// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Windows give the points that the whole file has there, and lists name their files.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <set>
#include <sstream>
#include <tuple>
#include <vector>

#include <linelet/io/copc_ranges.h>
#include <linelet/io/input_list.h>
#include <linelet/io/point_file.h>
#include <linelet/io/point_stream.h>
#include <linelet/io/virtual_cloud.h>

#include "io/file_helpers.h"
#include "test_data.h"

using namespace linelet;
using namespace linelet::io;
using namespace linelet::test;

namespace {

using Place = std::tuple<double, double, double>;

/** \brief Places of the points in \a box, sorted. */
std::vector<Place>
placesIn(const Cloud& cloud, const std::vector<double>& box)
{
  std::vector<Place> places;
  for (const Point& point : cloud.points) {
    const Point p = cloud.shift + point;
    if (p.x() >= box[0] && p.x() <= box[2] && p.y() >= box[1] && p.y() <= box[3])
      places.emplace_back(p.x(), p.y(), p.z());
  }
  std::sort(places.begin(), places.end());
  return places;
}

/** \brief Position and attributes of every point in \a box. */
std::multiset<std::vector<double>>
recordsIn(const Cloud& cloud, const std::vector<double>& box)
{
  std::multiset<std::vector<double>> records;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Point p = cloud.shift + cloud.points[i];
    if (p.x() < box[0] || p.x() > box[2] || p.y() < box[1] || p.y() > box[3])
      continue;
    std::vector<double> record = {p.x(), p.y(), p.z()};
    for (const Column& column : cloud.columns)
      std::visit([&](const auto& v) { record.push_back(static_cast<double>(v[i])); },
                 column.values);
    records.insert(std::move(record));
  }
  return records;
}

/** \brief Grid coordinates of the points of a LAS 1.4 file, sorted. */
std::vector<std::array<std::int32_t, 3>>
stepsOf(const std::string& las)
{
  std::vector<std::array<std::int32_t, 3>> steps(numberAt<std::uint64_t>(las, 247));
  std::size_t at = numberAt<std::uint32_t>(las, 96);
  for (auto& step : steps) {
    step = {numberAt<std::int32_t>(las, at),
            numberAt<std::int32_t>(las, at + 4),
            numberAt<std::int32_t>(las, at + 8)};
    at += numberAt<std::uint16_t>(las, 105);
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

/** \brief Parts of the box of \a whole, at several distances. */
std::vector<ReadOptions>
windowsOf(const Cloud& whole)
{
  Point low = whole.shift + whole.points.front(), high = low;
  for (const Point& point : whole.points) {
    low = low.cwiseMin(whole.shift + point);
    high = high.cwiseMax(whole.shift + point);
  }
  std::vector<ReadOptions> windows;
  for (const double resolution : {0.0, 0.5, 3.0, 20.0, 500.0})
    for (const double part : {1.0, 0.4, 0.05}) {
      // Corners between the steps of the grid, so that rounding never meets a point.
      const Point from = low + (1 - part) / 3 * (high - low) - Point::Constant(0.00037);
      const Point to = from + part * (high - low) + Point::Constant(0.00071);
      ReadOptions options;
      options.bounds_3d = {from.x(), from.y(), from.z(), to.x(), to.y(), to.z()};
      options.resolution = resolution;
      windows.push_back(options);
    }
  return windows;
}

} // namespace

TEST(Windows, HoldThePointsThatTheWholeFileHasThere)
{
  LINELET_NEEDS_DATA("readers/copc");
  LINELET_NEEDS_DATA("lidar/bcts");
  for (const char* name : {"readers/copc/laspy_simple.copc.laz",
                           "readers/copc/laspy_simple_with_page.copc.laz",
                           "readers/copc/silvimetric_test_data_2.copc.laz",
                           "readers/laz/pt1_v1_pointwise.laz",
                           "lidar/bcts/bcts_1.laz"}) {
    SCOPED_TRACE(name);
    const std::string path = dataPath(name).string();
    const Cloud whole = readCloud(path);
    const Point first = whole.shift + whole.points[whole.points.size() / 2];
    for (const double half : {0.001, 1.0, 30.0, 1e7}) {
      ReadOptions options;
      options.bounds = {
          first.x() - half, first.y() - half, first.x() + half, first.y() + half};
      options.shift = whole.shift;
      const Cloud part = readCloud(path, options);
      const std::vector<Place> places = placesIn(whole, options.bounds);
      EXPECT_TRUE(places == placesIn(part, options.bounds));
      EXPECT_EQ(part.points.size(), places.size());
    }
  }
}

// A window of layered LAZ once read only the coordinates: every class in it was 0.
TEST(Windows, HoldTheAttributesThatTheWholeFileHasThere)
{
  LINELET_NEEDS_DATA("readers/copc");
  LINELET_NEEDS_DATA("lidar/laz");
  for (const char* name : {"readers/copc/laspy_simple.copc.laz",
                           "readers/laz/pt1_v1_pointwise.laz",
                           "lidar/laz/AHN4corridor_12AN2_20.laz"}) {
    SCOPED_TRACE(name);
    const std::string path = dataPath(name).string();
    const Cloud whole = readCloud(path);
    const Point middle = whole.shift + whole.points[whole.points.size() / 2];
    ReadOptions options;
    options.bounds = {
        middle.x() - 40, middle.y() - 40, middle.x() + 40, middle.y() + 40};
    options.shift = whole.shift;
    const Cloud part = readCloud(path, options);
    ASSERT_GT(part.points.size(), 0U);
    EXPECT_TRUE(recordsIn(whole, options.bounds) == recordsIn(part, options.bounds));
  }
}

// Every point of a window is in one of the ranges, and far ones are not read.
TEST(Windows, RangesOfCopcFilesHoldWhatIsThere)
{
  LINELET_NEEDS_DATA("readers/copc");
  std::size_t read = 0, all = 0;
  for (const char* name :
       {"laspy_simple.copc.laz", "silvimetric_test_data_2.copc.laz"}) {
    SCOPED_TRACE(name);
    const std::string path = (dataPath("readers/copc") / name).string();
    const Cloud whole = readCloud(path);
    for (std::size_t i = 0; i < whole.points.size();
         i += 1 + whole.points.size() / 20) {
      const Point at = whole.shift + whole.points[i];
      const std::array<double, 4> bounds = {
          at.x() - 5, at.y() - 5, at.x() + 5, at.y() + 5};
      const auto ranges = copcRanges(path, bounds);
      ASSERT_TRUE(ranges);
      std::vector<bool> held(whole.points.size(), false);
      PointStream stream(path, {}, 3000);
      for (const PointRange& range : *ranges) {
        std::size_t place = range.first;
        Cloud block;
        for (stream.seek(range.first, range.first + range.count); stream.next(block);
             place += block.points.size())
          for (std::size_t k = 0; k < block.points.size(); ++k) {
            held.at(place + k) = true;
            EXPECT_LT(
                (block.shift + block.points[k] - whole.shift - whole.points[place + k])
                    .norm(),
                1e-6);
          }
        EXPECT_EQ(place, range.first + range.count);
      }
      for (std::size_t k = 0; k < held.size(); ++k) {
        const Point p = whole.shift + whole.points[k];
        if (p.x() >= bounds[0] && p.x() <= bounds[2] && p.y() >= bounds[1] &&
            p.y() <= bounds[3]) {
          EXPECT_TRUE(held[k]) << k;
        }
      }
      read += static_cast<std::size_t>(std::count(held.begin(), held.end(), true));
      all += held.size();
    }
  }
  EXPECT_LT(read, all / 2);
  EXPECT_FALSE(copcRanges(dataPath("lidar/bcts/bcts_1.laz").string(), {0, 0, 1, 1}));
}

TEST(Windows, OfCopcFilesAreThoseOfCopcReader)
{
  LINELET_NEEDS_DATA("readers/copc");
  const char* chosen = std::getenv("LINELET_LAZ_PYTHON");
  const std::string python = chosen != nullptr ? chosen : "python3";
  if (std::system((python + " -c 'import laspy, lazrs' 2>/dev/null").c_str()) != 0)
    GTEST_SKIP() << "no laspy and lazrs in " << python
                 << "; LINELET_LAZ_PYTHON names a Python that has them";
  const Folder folder;
  // Per line: the sorted grid coordinates of a file's points in the bounds a[1:7] and
  // in the levels that the distance a[0] needs.
  writeBytes(folder.file("query.py"),
             "import laspy, numpy, sys\n"
             "for k, line in enumerate(open(sys.argv[2])):\n"
             "    a = [float(x) for x in line.split()]\n"
             "    with laspy.CopcReader.open(sys.argv[1]) as reader:\n"
             "        p = reader.query(bounds=laspy.copc.Bounds(numpy.array(a[1:4]), "
             "numpy.array(a[4:7])), resolution=a[0] or None)\n"
             "    xyz = numpy.stack([p.X, p.Y, p.Z], 1).astype('<i4')\n"
             "    xyz = xyz[numpy.lexsort(xyz.T[::-1])]\n"
             "    open(sys.argv[3] + str(k), 'wb').write(xyz.tobytes())\n");
  std::size_t windows = 0, points = 0;
  for (const char* name : {"lasR_example.copc.laz",
                           "laspy_simple.copc.laz",
                           "laspy_simple_with_page.copc.laz",
                           "silvimetric_test_data_2.copc.laz"}) {
    SCOPED_TRACE(name);
    const std::string path = (dataPath("readers/copc") / name).string();
    const std::vector<ReadOptions> queries = windowsOf(readCloud(path));
    std::ostringstream lines;
    for (const ReadOptions& options : queries) {
      lines << options.resolution << std::fixed;
      for (const double number : options.bounds_3d)
        lines << ' ' << number;
      lines << '\n';
    }
    writeBytes(folder.file("queries"), lines.str());
    ASSERT_EQ(std::system((python + " " + folder.file("query.py") + " " + path + " " +
                           folder.file("queries") + " " + folder.file("xyz"))
                              .c_str()),
              0);
    for (std::size_t k = 0; k < queries.size(); ++k) {
      SCOPED_TRACE(k);
      writeCloud(folder.file("out.las"), readCloud(path, queries[k]));
      const auto found = stepsOf(bytesOf(folder.file("out.las")));
      const std::string theirs = bytesOf(folder.file("xyz" + std::to_string(k)));
      ASSERT_EQ(theirs.size(), 12 * found.size());
      EXPECT_EQ(std::memcmp(theirs.data(), found.data(), theirs.size()), 0);
      ++windows;
      points += found.size();
    }
  }
  EXPECT_EQ(windows, 60U);
  EXPECT_GT(points, 10000U);
}

TEST(Windows, ASelfReferencingCopcPageEnds)
{
  LINELET_NEEDS_DATA("readers/copc");
  const Folder folder;
  std::string bytes = bytesOf(dataPath("readers/copc/laspy_simple.copc.laz"));
  // As many entries as the file can hold, each pointing to this page again.
  const std::uint64_t at = bytes.size(), size = 8000000;
  std::string entry(32, '\0');
  const std::int32_t another = -1, length = 32;
  std::memcpy(&entry[16], &at, 8);
  std::memcpy(&entry[24], &length, 4);
  std::memcpy(&entry[28], &another, 4);
  for (std::uint64_t i = 0; i < size; i += entry.size())
    bytes += entry;
  std::memcpy(&bytes[375 + 54 + 40], &at, 8);
  const std::uint64_t page = length;
  std::memcpy(&bytes[375 + 54 + 48], &page, 8);
  writeBytes(folder.file("a.copc.laz"), bytes);
  std::vector<std::string> warnings;
  const Cloud cloud = readCloud(folder.file("a.copc.laz"), {}, &warnings);
  EXPECT_EQ(cloud.points.size(), 1065U);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("more entries than the file has room for"),
            std::string::npos)
      << warnings[0];
}

TEST(Windows, ThatBoundNothingAreRefused)
{
  const Folder folder;
  writeBytes(folder.file("a.xyz"), "0 0 0\n1 1 1\n");
  ReadOptions options;
  options.bounds = {1, 2, 3};
  EXPECT_THROW(readCloud(folder.file("a.xyz"), options), FileError);
  options.bounds = {1, 1, 0, 2};
  EXPECT_THROW(readCloud(folder.file("a.xyz"), options), FileError);
  options.bounds = {0.5, 0.5, 2, 2};
  EXPECT_EQ(readCloud(folder.file("a.xyz"), options).points.size(), 1U);
}

TEST(InputList, FoldersListsAndVirtualCloudsNameTheirFiles)
{
  const Folder folder;
  writeBytes(folder.file("b.xyz"), "0 0 0\n");
  writeBytes(folder.file("a.xyz"), "1 1 1\n");
  writeBytes(folder.file("notes.md"), "no points");
  const std::vector<std::string> both = {folder.file("a.xyz"), folder.file("b.xyz")};
  EXPECT_EQ(findInputs({folder.path().string()}).files, both);
  EXPECT_FALSE(findInputs({both[0]}).several);

  writeVirtualCloud(folder.file("v.vpc"), {summaryOf(both[0]), summaryOf(both[1])});
  EXPECT_EQ(findInputs({folder.file("v.vpc")}).files, both);
  EXPECT_TRUE(findInputs({folder.file("v.vpc")}).several);

  writeBytes(folder.file("list.txt"), "# tiles\na.xyz\n" + both[1] + "\n");
  EXPECT_EQ(findInputs({folder.file("list.txt")}).files, both);
  writeBytes(folder.file("points.txt"), "1 2 3\n");
  EXPECT_EQ(findInputs({folder.file("points.txt")}).files.front(),
            folder.file("points.txt"));
  writeBytes(folder.file("bad.txt"), "a.xyz\nnone.xyz\n");
  EXPECT_THROW(findInputs({folder.file("bad.txt")}), FileError);
  writeBytes(
      folder.file("far.vpc"),
      R"({"features":[{"assets":{"data":{"href":"https://example.org/a.laz"}}}]})");
  EXPECT_THROW(findInputs({folder.file("far.vpc")}), FileError);
}

TEST(InputList, TheVirtualCloudOfOtherSoftwareIsRead)
{
  LINELET_NEEDS_DATA("lidar/bcts/bcts.vpc");
  const InputList list = findInputs({dataPath("lidar/bcts/bcts.vpc").string()});
  ASSERT_EQ(list.files.size(), 4U);
  EXPECT_EQ(summaryOf(list.files[0]).points, 531662U);
}
