// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// LAZ files: those of other writers are read record for record, and other readers read
// ours. PyPI's laszip and lazrs are called through the Python in LINELET_LAZ_PYTHON
// (else python3); without them these tests are skipped.

#include <cstdio>
#include <map>
#include <random>
#include <sstream>

#include <linelet/io/point_file.h>

#include "io/file_helpers.h"
#include "test_data.h"

using namespace linelet;
using namespace linelet::io;
using namespace linelet::test;

namespace fs = std::filesystem;

namespace {

std::string
recordsOf(const fs::path& las)
{
  const std::string bytes = bytesOf(las);
  const std::size_t count = bytes[25] >= 4 ? numberAt<std::uint64_t>(bytes, 247)
                                           : numberAt<std::uint32_t>(bytes, 107);
  return bytes.substr(numberAt<std::uint32_t>(bytes, 96),
                      count * numberAt<std::uint16_t>(bytes, 105));
}

/** The point records of a file, as linelet writes them to LAS. */
std::string
recordsByLinelet(const fs::path& path, const Folder& folder)
{
  writeCloud(folder.file("out.las"), readCloud(path.string()));
  return recordsOf(folder.file("out.las"));
}

std::vector<fs::path>
lazFiles()
{
  std::vector<fs::path> files;
  for (const char* folder :
       {"readers/laz", "readers/copc", "readers/las", "lidar/bcts"})
    for (const auto& entry : fs::directory_iterator(dataPath(folder)))
      if (entry.path().extension() == ".laz" &&
          entry.path().filename().string().rfind("laszip_broken", 0) != 0)
        files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

bool
isCompatible(const fs::path& path)
{
  return path.filename().string().find("compat") != std::string::npos;
}

std::string
python()
{
  const char* path = std::getenv("LINELET_LAZ_PYTHON");
  return path != nullptr ? path : "python3";
}

bool
hasOracle()
{
  return std::system(
             (python() + " -c 'import laspy, laszip, lazrs' 2>/dev/null").c_str()) == 0;
}

/** Writes the point records that \a backend (Laszip, Lazrs) reads from \a path to
 * \a out. */
bool
askOracle(const std::string& backend, const fs::path& path, const std::string& out)
{
  const std::string program = "import laspy, sys; open(sys.argv[2], 'wb').write("
                              "laspy.read(sys.argv[1], laz_backend=laspy.LazBackend." +
                              backend + ").points.array.tobytes())";
  return std::system((python() + " -c \"" + program + "\" '" + path.string() + "' '" +
                      out + "' 2>/dev/null")
                         .c_str()) == 0;
}

#define NEEDS_ORACLE                                                                   \
  if (!hasOracle())                                                                    \
  GTEST_SKIP() << "no laspy, laszip and lazrs in " << python()                         \
               << "; LINELET_LAZ_PYTHON names a Python that has them"

Cloud
testCloud(std::size_t count, unsigned seed)
{
  std::mt19937 random(seed);
  Cloud cloud;
  cloud.shift = {500000, 5000000, 100};
  std::vector<std::uint8_t> classes, channels;
  std::vector<double> times;
  std::vector<float> extra;
  for (std::size_t i = 0; i < count; ++i) {
    cloud.points.push_back({0.001 * static_cast<double>(random() % 100000),
                            0.001 * static_cast<double>(i),
                            0.001 * static_cast<double>(random() % 3000)});
    classes.push_back(static_cast<std::uint8_t>(random() % 3));
    channels.push_back(static_cast<std::uint8_t>(i / 7 % 4));
    times.push_back(1e8 + 1e-5 * static_cast<double>(i));
    extra.push_back(static_cast<float>(random() % 10));
  }
  cloud.set({"classification", classes, {}});
  cloud.set({"scanner_channel", channels, {}});
  cloud.set({"gps_time", times, {}});
  cloud.set({"extra", extra, {}});
  return cloud;
}

} // namespace

TEST(LazFiles, FilesOfEqualReferenceHashHoldEqualPoints)
{
  LINELET_NEEDS_DATA("readers/laz/reference_hashes.txt");
  const Folder folder;
  std::ifstream list(dataPath("readers/laz/reference_hashes.txt"));
  std::map<std::string, std::string> records; // by hash
  std::string name, hash, count;
  int files = 0;
  while (list >> name >> hash >> count) {
    SCOPED_TRACE(name);
    const std::string found = recordsByLinelet(dataPath("readers/laz/" + name), folder);
    const auto [place, is_new] = records.emplace(hash, found);
    EXPECT_TRUE(is_new || place->second == found);
    ++files;
  }
  EXPECT_GT(files, 50);
}

TEST(LazFiles, EveryRecordEqualsThatOfLaszip)
{
  LINELET_NEEDS_DATA("readers/laz");
  NEEDS_ORACLE;
  const Folder folder;
  for (const fs::path& path : lazFiles()) {
    SCOPED_TRACE(path.filename());
    if (isCompatible(path))
      continue; // read as the formats they stand for, see below
    ASSERT_TRUE(askOracle("Laszip", path, folder.file("oracle")));
    EXPECT_TRUE(recordsByLinelet(path, folder) == bytesOf(folder.file("oracle")));
  }
}

// Formats 6 to 10 stored as 1 to 5 are read as the formats they stand for: equal to
// files of the same series in those formats, except for scan angles, which increase by
// 271 steps here, and the class byte and flags of three points, which all readers
// report differently.
TEST(LazFiles, CompatibilityModeIsReadAsTheOriginalFormat)
{
  LINELET_NEEDS_DATA("readers/laz");
  for (const char* format : {"6", "7", "8", "9", "10"})
    for (const char* ending : {"_compat_v0.las", "_compat_v2.laz"}) {
      const std::string name = std::string("readers/laz/pt") + format;
      SCOPED_TRACE(name + ending);
      const Cloud compatible = readCloud(dataPath(name + ending));
      const Cloud native = readCloud(dataPath(name + "_v3.laz"));
      ASSERT_EQ(compatible.points.size(), native.points.size());
      for (const Column& column : native.columns) {
        const bool packed = column.name == "classification" ||
                            column.name == "synthetic" || column.name == "key_point" ||
                            column.name == "withheld";
        const Column* same = compatible.find(column.name);
        ASSERT_NE(same, nullptr) << column.name;
        for (std::size_t i = 0; i < native.points.size(); ++i) {
          const double value = valueAt(*same, i);
          if (column.name == "scan_angle") {
            EXPECT_NEAR(
                value, 0.006 * (static_cast<double>(271 * i % 60001) - 30000), 1e-4);
          }
          else if (!packed || i == 0 || i % 137 != 0) {
            ASSERT_EQ(value, valueAt(column, i)) << column.name << " of point " << i;
          }
        }
      }
      EXPECT_EQ(compatible.find("LAS 1.4 scan angle"), nullptr);
      // Rewritten, the file is of that format, with no trace of the mode.
      const Folder folder;
      writeCloud(folder.file("native.laz"), compatible);
      std::vector<std::string> warnings;
      const Cloud again = readCloud(folder.file("native.laz"), {}, &warnings);
      EXPECT_TRUE(warnings.empty()) << warnings.front();
      EXPECT_NE(again.format.find(std::string("point format ") + format),
                std::string::npos)
          << again.format;
    }
}

TEST(LazFiles, OtherReadersReadOurFiles)
{
  LINELET_NEEDS_DATA("readers/laz");
  NEEDS_ORACLE;
  const Folder folder;
  for (const fs::path& path : lazFiles()) {
    SCOPED_TRACE(path.filename());
    writeCloud(folder.file("out.laz"), readCloud(path.string()));
    const std::string records = recordsByLinelet(path, folder);
    for (const char* backend : {"Laszip", "Lazrs"}) {
      ASSERT_TRUE(askOracle(backend, folder.file("out.laz"), folder.file("oracle")))
          << backend;
      EXPECT_TRUE(records == bytesOf(folder.file("oracle"))) << backend;
    }
  }
}

TEST(LazFiles, CloudsOfAnySizeAreReadByAllReaders)
{
  const Folder folder;
  const bool oracle = hasOracle();
  for (const std::size_t count : {0, 1, 2, 49999, 50000, 50001, 100000}) {
    SCOPED_TRACE(count);
    const Cloud cloud = testCloud(count, 7);
    writeCloud(folder.file("a.las"), cloud);
    writeCloud(folder.file("a.laz"), cloud);
    const std::string records = recordsOf(folder.file("a.las"));
    EXPECT_TRUE(recordsByLinelet(folder.file("a.laz"), folder) == records);
    for (const char* backend : {"Laszip", "Lazrs"})
      if (oracle) {
        ASSERT_TRUE(askOracle(backend, folder.file("a.laz"), folder.file("oracle")))
            << backend;
        EXPECT_TRUE(records == bytesOf(folder.file("oracle"))) << backend;
      }
  }
}

TEST(LazFiles, MalformedFilesAreRefusedInOneSentence)
{
  LINELET_NEEDS_DATA("readers/laz/malformed");
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(dataPath("readers/laz/malformed")))
    files.push_back(entry.path());
  for (const auto& entry : fs::directory_iterator(dataPath("readers/las")))
    if (entry.path().filename().string().rfind("laszip_broken", 0) == 0)
      files.push_back(entry.path());
  EXPECT_GE(files.size(), 9U);
  for (const fs::path& path : files) {
    SCOPED_TRACE(path.filename());
    try {
      readCloud(path.string());
      ADD_FAILURE() << "was read";
    }
    catch (const FileError& error) {
      EXPECT_EQ(std::string(error.what()).find(path.string()), 0U);
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

TEST(LazFiles, ChangedBytesOfThePointsAreNoticedOrChangeNothingElse)
{
  LINELET_NEEDS_DATA("readers/laz/pt7_v3.laz");
  const Folder folder;
  std::mt19937 random(3);
  int refused = 0;
  for (const char* name : {"pt1_v2.laz", "pt3_v1.laz", "pt7_v3.laz", "pt10_v4.laz"}) {
    const std::string good = bytesOf(dataPath("readers/laz/" + std::string(name)));
    const std::size_t count =
        readCloud(dataPath("readers/laz/" + std::string(name)).string()).points.size();
    for (int i = 0; i < 100; ++i) {
      std::string bad = good;
      const std::size_t from = numberAt<std::uint32_t>(bad, 96);
      bad[from + random() % (bad.size() - from)] = static_cast<char>(random());
      writeBytes(folder.file("bad.laz"), bad);
      try {
        EXPECT_EQ(readCloud(folder.file("bad.laz")).points.size(), count);
      }
      catch (const FileError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 200) << "changes that move the end of the data are noticed";
}

TEST(LazFiles, LenientReadingKeepsTheChunksBeforeTheDamage)
{
  const Folder folder;
  writeCloud(folder.file("a.laz"), testCloud(120000, 1));
  const std::string bytes = bytesOf(folder.file("a.laz"));
  writeBytes(folder.file("cut.laz"), bytes.substr(0, bytes.size() * 2 / 3));
  EXPECT_THROW(readCloud(folder.file("cut.laz")), FileError);
  ReadOptions lenient;
  lenient.lenient = true;
  const Cloud whole = readCloud(folder.file("a.laz"));
  const Cloud kept = readCloud(folder.file("cut.laz"), lenient);
  ASSERT_EQ(kept.points.size(), 50000U);
  for (std::size_t i = 0; i < kept.points.size(); ++i)
    ASSERT_EQ(kept.points[i], whole.points[i]);
}
