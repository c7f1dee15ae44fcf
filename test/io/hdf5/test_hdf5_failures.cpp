// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <fstream>
#include <string>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <linelet/io/vector_file.h>

#include "io/hdf5/hdf5_test.h"
#include "test_data.h"

using namespace linelet;
using namespace linelet::test;

namespace fs = std::filesystem;

namespace {

/** \brief Peak memory of this process so far, in MB. */
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

TEST_F(Hdf5, ABlockOfOtherAttributesIsRefused)
{
  Hdf5CloudWriter writer(folder.file("cloud.h5"), example(1));
  Cloud other = example(1);
  other.columns.pop_back();
  EXPECT_THROW(writer.append(other), FileError);
}

TEST_F(Hdf5, MemoryDoesNotGrowWithTheBlocks)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers keep what was freed";
#endif
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

TEST_F(Hdf5, ReportsErrorsInOneLine)
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

// Whatever the bytes, the result is consistent, or a FileError.
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
