// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/io/file_error.h>
#include <linelet/io/hdf5_file.h>
#include <linelet/io/point_file.h>
#include <linelet/io/vector_file.h>

#include "io/file_helpers.h"
#include "test_data.h"

using namespace linelet;
using namespace linelet::io;
using namespace linelet::test;

namespace fs = std::filesystem;

namespace {

/** \brief A cloud with a column of every type, a tensor and a name with a slash. */
Cloud
example(std::size_t count, std::size_t first = 0)
{
  Cloud cloud;
  cloud.shift = Point(512000.25, 5427000.5, 200);
  cloud.wkt = "LOCAL_CS[\"somewhere\"]";
  for (std::size_t i = first; i < first + count; ++i)
    cloud.points.emplace_back(0.1 * static_cast<double>(i), std::sqrt(i), 1e-3);
  const auto fill = [&](const char* name, auto zero, const char* description = "") {
    std::vector<decltype(zero)> values;
    for (std::size_t i = first; i < first + count; ++i)
      values.push_back(static_cast<decltype(zero)>(i * 1234567 + values.size() % 3));
    cloud.set({name, std::move(values), description});
  };
  fill("i8", std::int8_t{});
  fill("classification", std::uint8_t{});
  for (const char* entry : {"xx", "xy", "xz", "yy", "yz", "zz"})
    fill(entry, float{}, "neighborhood tensor");
  fill("a/b.", std::int16_t{}, "a description with \xC3\xA4");
  fill("intensity", std::uint16_t{});
  fill("i32", std::int32_t{});
  fill("u32", std::uint32_t{});
  fill("i64", std::int64_t{});
  fill("u64", std::uint64_t{});
  fill("time", double{});
  return cloud;
}

/** \brief NaN for NaN. */
bool
sameBits(const Values& a, const Values& b)
{
  return a.index() == b.index() &&
         std::visit(
             [&](const auto& values) {
               using V = std::decay_t<decltype(values)>;
               const V& others = std::get<V>(b);
               return values.size() == others.size() &&
                      std::memcmp(values.data(),
                                  others.data(),
                                  values.size() * sizeof(values[0])) == 0;
             },
             a);
}

void
expectEqual(const Cloud& a, const Cloud& b)
{
  EXPECT_EQ(a.shift, b.shift);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.wkt, b.wkt);
  ASSERT_EQ(a.columns.size(), b.columns.size());
  for (std::size_t i = 0; i < a.columns.size(); ++i) {
    EXPECT_EQ(a.columns[i].name, b.columns[i].name);
    EXPECT_EQ(a.columns[i].description, b.columns[i].description);
    EXPECT_TRUE(sameBits(a.columns[i].values, b.columns[i].values))
        << a.columns[i].name;
  }
}

Cloud
part(const Cloud& cloud, std::size_t first, std::size_t count)
{
  Cloud some = cloud;
  const auto cut = [&](auto& values) {
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
    values.resize(count);
  };
  cut(some.points);
  for (Column& column : some.columns)
    std::visit(cut, column.values);
  return some;
}

class Hdf5 : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (!hasHdf5())
      GTEST_SKIP() << "built without HDF5";
  }

  Folder folder;
};

/** \brief Largest memory of this process so far, in MB. */
double
peakMemory()
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0)
      return std::stod(line.substr(6)) / 1024;
  return 0;
}

} // namespace

TEST_F(Hdf5, KeepsEverythingOfACloud)
{
  for (const std::size_t count : {0u, 1u, 3u, 50000u}) {
    const Cloud cloud = example(count);
    writeCloud(folder.file("cloud.h5"), cloud);
    expectEqual(readCloud(folder.file("cloud.h5")), cloud);
  }
}

TEST_F(Hdf5, PointsWithoutPlaceAndColumnsWithoutNameComeBack)
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
    EXPECT_FALSE(fs::exists(path)) << "whole or not at all";
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

TEST_F(Hdf5, ABlockOfOtherAttributesIsRefused)
{
  Hdf5CloudWriter writer(folder.file("cloud.h5"), example(1));
  Cloud other = example(1);
  other.columns.pop_back();
  EXPECT_THROW(writer.append(other), FileError);
}

TEST_F(Hdf5, MemoryDoesNotGrowWithTheBlocks)
{
  const Cloud block = example(100000);
  Hdf5CloudWriter writer(folder.file("cloud.h5"), part(block, 0, 0));
  for (int k = 0; k < 5; ++k)
    writer.append(block);
  const double before = peakMemory();
  for (int k = 0; k < 25; ++k) // 2.5 million points of 80 bytes: 200 MB
    writer.append(block);
  EXPECT_LT(peakMemory() - before, 20);
  writer.commit();
  EXPECT_EQ(hdf5Fragments(folder.file("cloud.h5")).back().first, 2900000u);
}

TEST_F(Hdf5, AKilledWriterLeavesTheOldFile)
{
  const std::string path = folder.file("cloud.h5");
  const Cloud old = example(3);
  for (const bool was_there : {false, true}) {
    if (was_there)
      writeCloud(path, old);
    int pipe[2];
    ASSERT_EQ(::pipe(pipe), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      const Cloud block = example(20000);
      Hdf5CloudWriter writer(path, block);
      for (;;) {
        writer.append(block);
        if (::write(pipe[1], "x", 1) != 1)
          ::_exit(1);
      }
    }
    char byte = 0;
    for (int k = 0; k < 3; ++k)
      ASSERT_EQ(::read(pipe[0], &byte, 1), 1);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ::close(pipe[0]);
    ::close(pipe[1]);
    ASSERT_EQ(fs::exists(path), was_there);
    if (was_there)
      expectEqual(readCloud(path), old);
  }
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

  // Curves alone, as writeCurves makes them; and none.
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

TEST_F(Hdf5, SaysInOneLineWhatIsWrong)
{
  writeBytes(folder.file("text.h5"), "no HDF5 at all");
  writeBytes(folder.file("empty.h5"), "");
  for (const char* name : {"text.h5", "empty.h5", "none.h5"})
    try {
      readCloud(folder.file(name));
      FAIL() << name;
    }
    catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  EXPECT_THROW(writeCloud("/dev/null/cloud.h5", example(1)), FileError);
  EXPECT_THROW(writeCloud(folder.file("cloud.h5"), example(1), {true}), FileError);
}

// Whatever the bytes are, what comes out fits together, or is a FileError.
TEST_F(Hdf5, DamagedFilesAreRefusedOrReadInPart)
{
  const std::string path = folder.file("cloud.h5");
  Cloud cloud = example(300);
  if (fs::exists(dataPath("readers/las/pdal_extrabytes.las")))
    cloud =
        part(readCloud(dataPath("readers/las/pdal_extrabytes.las").string()), 0, 300);
  CurveNetwork network;
  Curve curve;
  curve.points.resize(40, Point(1, 2, 3));
  network.curves.assign(5, curve);
  network.junctions.push_back({Point(1, 2, 3), {0, 3}});
  writeHdf5(path, cloud, network);
  const std::string whole = bytesOf(path);

  std::size_t refused = 0;
  const auto tryIt = [&](const std::string& bytes) {
    writeBytes(folder.file("damaged.h5"), bytes);
    try {
      const Cloud read = readCloud(folder.file("damaged.h5"));
      for (const Column& column : read.columns)
        ASSERT_EQ(size(column.values), read.points.size());
      try {
        writeCloud(folder.file("out.las"), read);
      }
      catch (const FileError&) {
      }
    }
    catch (const FileError& error) {
      ++refused;
      ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
    try {
      for (const Curve& c : readCurves(folder.file("damaged.h5")).curves)
        ASSERT_LE(c.points.size(), 200u);
    }
    catch (const FileError&) {
    }
  };
  for (std::size_t length = 0; length < whole.size(); length += 1 + whole.size() / 97)
    tryIt(whole.substr(0, length));
  EXPECT_GT(refused, 90u) << "cut files";
  constexpr unsigned seed = 17;
  SCOPED_TRACE("seed " + std::to_string(seed));
  boost::random::mt19937 random(seed);
  boost::random::uniform_int_distribution<std::size_t> place(0, whole.size() - 1);
  boost::random::uniform_int_distribution<int> value(0, 255), changes(1, 8);
  for (int k = 0; k < 600; ++k) {
    std::string bytes = whole;
    for (int n = changes(random); n > 0; --n)
      bytes[place(random)] = static_cast<char>(value(random));
    tryIt(bytes);
  }
}
