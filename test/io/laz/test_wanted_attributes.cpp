// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// A subset of the attributes of a file, compared with reading all of them.

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include <linelet/io/point_file.h>

#include "io/file_helpers.h"
#include "test_data.h"

using namespace linelet;
using namespace linelet::io;
using namespace linelet::test;

namespace {

using Names = std::vector<std::string>;

std::vector<std::string>
files()
{
  std::vector<std::string> files;
  for (const char* folder : {"readers/laz", "readers/copc", "readers/las"})
    for (const auto& entry : std::filesystem::directory_iterator(dataPath(folder))) {
      const std::string ending = entry.path().extension().string();
      const std::string name = entry.path().filename().string();
      if ((ending == ".laz" || ending == ".las") && name.rfind("laszip_broken", 0) != 0)
        files.push_back(entry.path().string());
    }
  std::sort(files.begin(), files.end());
  return files;
}

bool
haveEqualBytes(const Values& a, const Values& b)
{
  return std::visit(
      [](const auto& left, const auto& right) {
        using T = typename std::decay_t<decltype(left)>::value_type;
        if constexpr (std::is_same_v<std::decay_t<decltype(left)>,
                                     std::decay_t<decltype(right)>>)
          return left.size() == right.size() &&
                 (left.empty() ||
                  std::memcmp(left.data(), right.data(), left.size() * sizeof(T)) == 0);
        else
          return false;
      },
      a,
      b);
}

/** \brief Reads \a names from \a path: equal to those of \a whole, read with
 * \a options. */
void
expectPartOf(const Cloud& whole,
             const std::string& path,
             const Names& names,
             ReadOptions options)
{
  SCOPED_TRACE(testing::PrintToString(names));
  options.attributes = names;
  const Cloud part = readCloud(path, options);
  EXPECT_TRUE(part.points == whole.points);
  EXPECT_EQ(part.shift, whole.shift);
  EXPECT_EQ(part.format, whole.format);
  std::size_t wanted = 0;
  for (const Column& column : whole.columns) {
    const bool is_wanted =
        std::find(names.begin(), names.end(), column.name) != names.end();
    const Column* found = part.find(column.name);
    ASSERT_EQ(found != nullptr, is_wanted) << column.name;
    if (found == nullptr)
      continue;
    ++wanted;
    EXPECT_TRUE(haveEqualBytes(found->values, column.values)) << column.name;
  }
  EXPECT_EQ(part.columns.size(), wanted);
}

void
expectPartsOf(const std::string& path, const ReadOptions& options)
{
  const Cloud whole = readCloud(path, options);
  expectPartOf(whole, path, {}, options);
  expectPartOf(whole, path, {"no such attribute"}, options);
  expectPartOf(whole, path, {"classification", "withheld"}, options);
  expectPartOf(whole, path, {"red", "gps_time", "scanner_channel"}, options);
  if (whole.points.size() < 10000) // each alone, where that is quick
    for (const Column& column : whole.columns)
      expectPartOf(whole, path, {column.name}, options);
}

} // namespace

TEST(WantedAttributes, OfLasAndLazAreThoseOfTheWholeFile)
{
  LINELET_NEEDS_DATA("readers/laz");
  LINELET_NEEDS_DATA("readers/copc");
  LINELET_NEEDS_DATA("readers/las");
  std::size_t read = 0;
  for (const std::string& path : files()) {
    SCOPED_TRACE(path);
    std::optional<Cloud> whole;
    try {
      whole = readCloud(path);
    }
    catch (const FileError&) {
      continue; // malformed files have no parts
    }
    ReadOptions window;
    window.threads = 1;
    expectPartsOf(path, window);
    if (whole->points.empty() || !whole->points.front().allFinite())
      continue;
    const Point middle = whole->shift + whole->points[whole->points.size() / 2];
    window.bounds = {
        middle.x() - 50, middle.y() - 50, middle.x() + 50, middle.y() + 50};
    expectPartsOf(path, window);
    ++read;
  }
  EXPECT_GT(read, 50U);
}

TEST(WantedAttributes, OfOtherFormatsAreThoseOfTheWholeFile)
{
  const Folder folder;
  Cloud cloud;
  for (int i = 0; i < 5; ++i)
    cloud.points.emplace_back(i, 2 * i, 0.5 * i);
  cloud.set({"classification", std::vector<std::uint8_t>{1, 2, 3, 4, 5}, {}});
  cloud.set({"intensity", std::vector<std::uint16_t>{5, 6, 7, 8, 9}, {}});
  cloud.set({"size", std::vector<float>{1, 2, 1, 2, 1}, {}});
  for (const char* ending : {".las", ".laz", ".pcd", ".ply", ".csv", ".h5"}) {
    SCOPED_TRACE(ending);
    const std::string path = folder.file(std::string("cloud") + ending);
    try {
      writeCloud(path, cloud);
    }
    catch (const FileError& error) {
      // Formats that were left out of the build.
      EXPECT_STREQ(ending, ".h5") << error.what();
      continue;
    }
    expectPartsOf(path, {});
  }
}

TEST(WantedAttributes, MakeAFileThatHoldsNoMore)
{
  LINELET_NEEDS_DATA("readers/laz/pt8_v3.laz");
  const Folder folder;
  for (const char* name : {"readers/laz/pt8_v3.laz", "readers/laz/pt3_v2.laz"}) {
    ReadOptions options;
    options.attributes = {"classification"};
    const Cloud cloud = readCloud(dataPath(name).string(), options);
    writeCloud(folder.file("out.laz"), cloud);
    ReadOptions again;
    again.shift = cloud.shift;
    const Cloud back = readCloud(folder.file("out.laz"), again);
    EXPECT_TRUE(back.points == cloud.points);
    EXPECT_TRUE(haveEqualBytes(back.find("classification")->values,
                               cloud.find("classification")->values));
    for (const Column& column : back.columns)
      if (column.name != "classification") {
        // Points without return numbers count as the only returns of their pulses.
        const bool is_return =
            column.name == "return_number" || column.name == "number_of_returns";
        for (std::size_t i = 0; i < back.points.size(); ++i)
          ASSERT_EQ(valueAt(column, i), is_return ? 1 : 0) << column.name;
      }
  }
}
