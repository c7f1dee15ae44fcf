// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Files read and written in parts equal those read and written at once.

#include <random>

#include <gtest/gtest.h>

#include <linelet/io/cloud_sink.h>
#include <linelet/io/file_error.h>
#include <linelet/io/merge.h>
#include <linelet/io/point_stream.h>

#include "io/file_helpers.h"
#include "random_seed.h"
#include "test_data.h"

namespace linelet::io {

namespace {

using test::bytesOf;
using test::Folder;

Cloud
randomCloud(std::size_t count, std::mt19937& random)
{
  std::uniform_real_distribution<double> place(0, 300);
  Cloud cloud;
  cloud.shift = {5e5, 4e6, 0};
  std::vector<std::uint8_t> classes, returns;
  std::vector<float> extra;
  for (std::size_t i = 0; i < count; ++i) {
    cloud.points.emplace_back(place(random), place(random), place(random) / 9);
    classes.push_back(static_cast<std::uint8_t>(random() % 19));
    returns.push_back(static_cast<std::uint8_t>(1 + random() % 5));
    extra.push_back(static_cast<float>(place(random)));
  }
  cloud.set({"return_number", returns, ""});
  cloud.set({"classification", classes, ""});
  cloud.set({"thickness", extra, "of something"});
  return cloud;
}

/** Reads \a from in parts, adds a column, and writes \a to in these parts. */
void
pump(const std::string& from, const std::string& to, std::size_t block)
{
  PointStream stream(from, {}, block);
  CloudSink sink(to);
  Cloud part;
  while (stream.next(part)) {
    part.set({"half", std::vector<float>(part.points.size(), 0.5F), "a column"});
    sink.add(part);
  }
  sink.commit();
}

} // namespace

TEST(CloudStream, PartsMakeTheWholeFile)
{
  std::mt19937 random(test::randomSeed());
  const Folder folder;
  for (const std::size_t count : {1, 8191, 8193, 50000, 120001})
    for (const char* ending : {".las", ".laz"}) {
      const std::string from = folder.file(std::string("in") + ending);
      writeCloud(from, randomCloud(count, random));
      Cloud whole = readCloud(from);
      whole.set({"half", std::vector<float>(whole.points.size(), 0.5F), "a column"});
      const std::string once = folder.file(std::string("once") + ending);
      const std::string parts = folder.file(std::string("parts") + ending);
      writeCloud(once, whole);
      pump(from, parts, 1 + random() % 100000);
      EXPECT_EQ(bytesOf(once), bytesOf(parts)) << count << ending;
    }
}

TEST(CloudStream, PartsReadAreTheWholeFile)
{
  for (const std::string name : {"lidar/laz", "lidar/bcts", "readers/laz"}) {
    if (!std::filesystem::exists(test::dataPath(name)))
      GTEST_SKIP() << "no reference data";
    std::size_t files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(test::dataPath(name))) {
      const std::string path = entry.path().string();
      if (entry.path().extension() != ".laz" || ++files > 4)
        continue;
      const Cloud whole = readCloud(path);
      PointStream stream(path, {}, 150000);
      Cloud part, all;
      bool begun = false;
      while (stream.next(part)) {
        if (begun)
          append(all, part);
        else
          all = part;
        begun = true;
      }
      EXPECT_EQ(all.points, whole.points) << path;
      EXPECT_EQ(all.shift, whole.shift) << path;
      ASSERT_EQ(all.columns.size(), whole.columns.size());
      for (std::size_t c = 0; c < all.columns.size(); ++c)
        EXPECT_TRUE(all.columns[c].values == whole.columns[c].values)
            << path << " " << all.columns[c].name;
    }
  }
}

TEST(CloudStream, WindowsAreThoseOfTheWholeFile)
{
  std::mt19937 random(7);
  const Folder folder;
  const std::string path = folder.file("in.laz");
  writeCloud(path, randomCloud(130000, random));
  ReadOptions options;
  options.bounds = {5e5 + 20, 4e6 + 30, 5e5 + 90, 4e6 + 200};
  const Cloud whole = readCloud(path, options);
  options.shift = whole.shift;
  PointStream stream(path, options, 1);
  Cloud part;
  Points points;
  while (stream.next(part))
    for (const Point& p : part.points)
      points.push_back(p + part.shift - whole.shift);
  ASSERT_EQ(points.size(), whole.points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    ASSERT_LT((points[i] - whole.points[i]).norm(), 1e-9) << "more than rounding";
}

TEST(CloudStream, OtherFormatsAreOnePart)
{
  const Folder folder;
  const std::string path = folder.file("in.xyz");
  test::writeBytes(path, "1 2 3\n4 5 6\n");
  PointStream stream(path, {}, 1);
  Cloud part;
  ASSERT_TRUE(stream.next(part));
  EXPECT_EQ(part.points.size(), 2u);
  EXPECT_FALSE(stream.next(part));
  EXPECT_THROW(CloudSink(folder.file("out.xyz")), FileError);
}

// Nothing remains of an unfinished file.
TEST(CloudStream, AnUnfinishedFileLeavesNothing)
{
  std::mt19937 random(7);
  const Folder folder;
  {
    CloudSink sink(folder.file("out.las"));
    sink.add(randomCloud(10, random));
  }
  EXPECT_FALSE(std::filesystem::exists(folder.file("out.las")));
}

} // namespace linelet::io
