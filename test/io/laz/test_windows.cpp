// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Windows give the points that the whole file has there, and lists name their files.

#include <set>
#include <tuple>

#include <linelet/io/input_list.h>
#include <linelet/io/point_file.h>
#include <linelet/io/virtual_cloud.h>

#include "io/file_helpers.h"
#include "test_data.h"

using namespace linelet;
using namespace linelet::io;
using namespace linelet::test;

namespace {

using Place = std::tuple<double, double, double>;

std::multiset<Place>
placesIn(const Cloud& cloud, const std::vector<double>& box)
{
  std::multiset<Place> places;
  for (const Point& point : cloud.points) {
    const Point p = cloud.shift + point;
    if (p.x() >= box[0] && p.x() <= box[2] && p.y() >= box[1] && p.y() <= box[3])
      places.insert({p.x(), p.y(), p.z()});
  }
  return places;
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
      EXPECT_TRUE(placesIn(whole, options.bounds) == placesIn(part, options.bounds));
      EXPECT_EQ(part.points.size(), placesIn(whole, options.bounds).size());
    }
  }
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
