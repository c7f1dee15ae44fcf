// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <linelet/io/vector_file.h>

#include "io/hdf5/hdf5_test.h"
#include "test_data.h"

using namespace linelet;
using namespace linelet::test;

namespace fs = std::filesystem;

TEST_F(Hdf5, KeepsEverythingOfACloud)
{
  for (const std::size_t count : {0u, 1u, 3u, 50000u}) {
    const Cloud cloud = example(count);
    writeCloud(folder.file("cloud.h5"), cloud);
    expectEqual(readCloud(folder.file("cloud.h5")), cloud);
  }
}

TEST_F(Hdf5, PointsWithoutPositionAndColumnsWithoutNameRoundTrip)
{
  Cloud cloud = example(5);
  cloud.points[2] = Point(std::nan(""), 1, 2);
  cloud.points[4].y() = std::numeric_limits<double>::infinity();
  writeCloud(folder.file("cloud.h5"), cloud);
  const Cloud back = readCloud(folder.file("cloud.h5"));
  EXPECT_TRUE(std::isnan(back.points[2].x()));
  EXPECT_EQ(back.points[2].y(), 1);
  EXPECT_EQ(back.points[4].y(), cloud.points[4].y());
  EXPECT_TRUE(fs::exists(folder.file("cloud.h5")));
  Cloud bare;
  bare.points = {Point(1, 2, 3)};
  writeCloud(folder.file("bare.h5"), bare);
  expectEqual(readCloud(folder.file("bare.h5")), bare);
}

TEST_F(Hdf5, LasThereAndBackKeepsEveryBit)
{
  LINELET_NEEDS_DATA("readers/las");
  std::size_t files = 0;
  std::vector<fs::path> paths;
  for (const char* place : {"readers/las", "readers/laz"})
    for (const auto& entry : fs::directory_iterator(dataPath(place)))
      paths.push_back(entry.path());
  for (const fs::path& path : paths) {
    SCOPED_TRACE(path.filename().string());
    Cloud cloud;
    try {
      cloud = readCloud(path.string());
    }
    catch (const FileError&) {
      continue; // one that nobody can read
    }
    ++files;
    writeCloud(folder.file("direct.las"), cloud);
    writeCloud(folder.file("cloud.h5"), cloud);
    const Cloud back = readCloud(folder.file("cloud.h5"));
    expectEqual(back, cloud);
    ASSERT_NE(back.las, nullptr);
    writeCloud(folder.file("back.las"), back);
    EXPECT_EQ(bytesOf(folder.file("back.las")), bytesOf(folder.file("direct.las")));
  }
  EXPECT_GT(files, 60u);
}

TEST_F(Hdf5, BlocksMakeTheSameCloudAndCanBeReadAlone)
{
  const Cloud cloud = example(70000);
  const std::string path = folder.file("cloud.h5");
  {
    Hdf5CloudWriter writer(path, part(cloud, 0, 0));
    for (std::size_t first = 0; first < 70000; first += 7000)
      writer.append(part(cloud, first, 7000));
    EXPECT_FALSE(fs::exists(path)) << "complete or not at all";
    writer.commit();
  }
  expectEqual(readCloud(path), cloud);
  const std::vector<Hdf5Fragment> fragments = hdf5Fragments(path);
  ASSERT_EQ(fragments.size(), 10u);
  for (std::size_t k = 0; k < 10; ++k) {
    const Hdf5Fragment& fragment = fragments[k];
    EXPECT_EQ(fragment.first, 7000 * k);
    EXPECT_EQ(fragment.count, 7000u);
    const Cloud some = readHdf5Points(path, fragment.first, fragment.count);
    expectEqual(some, part(cloud, fragment.first, fragment.count));
    Point low = some.shift + some.points[0], high = low;
    for (const Point& p : some.points) {
      low = low.cwiseMin(Point(some.shift + p));
      high = high.cwiseMax(Point(some.shift + p));
    }
    EXPECT_EQ(fragment.low, low);
    EXPECT_EQ(fragment.high, high);
  }
  EXPECT_EQ(readHdf5Points(path, 70000, 0).points.size(), 0u);
  EXPECT_THROW(readHdf5Points(path, 69999, 2), FileError);
}

TEST_F(Hdf5, CurvesAndTheirCloudShareAFile)
{
  CurveNetwork network;
  Curve curve;
  curve.points = {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0.5)};
  curve.support = {3, 4, 5};
  curve.front.kind = EndKind::Bounds;
  curve.back = {EndKind::Junction, 0};
  curve.noise = 0.25;
  network.curves.push_back(curve);
  curve.closed = true;
  curve.evidence = 12;
  curve.back = {EndKind::Loop, -1};
  network.curves.push_back(curve);
  network.junctions.push_back({Point(1, 1, 0.5), {0, 1}});

  const Cloud cloud = example(100);
  const std::string path = folder.file("both.h5");
  writeHdf5(path, cloud, network);
  expectEqual(readCloud(path), cloud);
  const CurveNetwork back = readCurves(path, cloud.shift);
  ASSERT_EQ(back.curves.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back.curves[i].points, network.curves[i].points);
    EXPECT_EQ(back.curves[i].closed, network.curves[i].closed);
    EXPECT_EQ(back.curves[i].support, curve.support);
    EXPECT_EQ(back.curves[i].front.kind, EndKind::Bounds);
    EXPECT_EQ(back.curves[i].back.kind, network.curves[i].back.kind);
    EXPECT_EQ(back.curves[i].back.junction, network.curves[i].back.junction);
    EXPECT_EQ(back.curves[i].noise, 0.25);
  }
  EXPECT_TRUE(std::isnan(back.curves[0].evidence));
  EXPECT_EQ(back.curves[1].evidence, 12);
  ASSERT_EQ(back.junctions.size(), 1u);
  EXPECT_EQ(back.junctions[0].curves, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(back.junctions[0].position, Point(1, 1, 0.5));

  // Curves alone, as written by writeCurves; and none.
  std::string wkt;
  writeCurves(
      folder.file("curves.h5"), network, Point(5e5, 0, 0), "LOCAL_CS[\"here\"]");
  EXPECT_EQ(readCurves(folder.file("curves.h5"), Point(5e5, 0, 0), &wkt).curves.size(),
            2u);
  EXPECT_EQ(wkt, "LOCAL_CS[\"here\"]");
  EXPECT_THROW(readCloud(folder.file("curves.h5")), FileError);
  writeCurves(folder.file("none.h5"), {});
  EXPECT_TRUE(readCurves(folder.file("none.h5")).curves.empty());
  writeCloud(folder.file("cloud.h5"), cloud);
  EXPECT_THROW(readCurves(folder.file("cloud.h5")), FileError);
}

TEST_F(Hdf5, OtherProgramsReadIt)
{
  if (std::system("h5dump --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "no h5dump";
  writeCloud(folder.file("cloud.h5"), example(3));
  const std::string text = folder.file("dump.txt");
  ASSERT_EQ(std::system(("h5dump " + folder.file("cloud.h5") + " > " + text).c_str()),
            0);
  const std::string dump = bytesOf(text);
  for (const char* part : {"GROUP \"StandardCartesianChart3D\"",
                           "DATASET \"Positions\"",
                           "H5T_IEEE_F64LE \"x\"",
                           "DATASET \"tensor\"",
                           "H5T_IEEE_F32LE \"zz\"",
                           "ATTRIBUTE \"Time\"",
                           "\"a/b.\"",
                           "512000, 5.427e+06, 200"})
    EXPECT_NE(dump.find(part), std::string::npos) << part;
}
