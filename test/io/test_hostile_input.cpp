// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// False counts and broken text are rejected without allocating memory for them.

#include <functional>
#include <map>

#include "io/hdf5/cloud_reader.h"
#include "io/las/las_reader.h"
#include "io/pcd/pcd_reader.h"
#include "io/ply/ply_reader.h"
#include "io/text/obj_vertices.h"
#include "io/text/text_reader.h"

#include "file_helpers.h"

using namespace linelet::io;
using namespace linelet::test;

namespace {

using Reader = Cloud (*)(const Source&);

std::string
refusal(Reader read, const std::string& bytes, bool lenient = false)
{
  Source source;
  source.name = "input";
  source.bytes = bytes;
  source.options.lenient = lenient;
  try {
    read(source);
  }
  catch (const FileError& error) {
    return error.what();
  }
  return {};
}

Cloud
parse(Reader read,
      const std::string& bytes,
      std::vector<std::string>* warnings = nullptr)
{
  Source source;
  source.name = "input";
  source.bytes = bytes;
  source.options.lenient = warnings != nullptr;
  source.warnings = warnings;
  return read(source);
}

void
expectRefusal(Reader read, const std::string& bytes, const std::string& what)
{
  const std::string message = refusal(read, bytes);
  EXPECT_NE(message.find(what), std::string::npos) << "'" << message << "'";
}

const std::string pcd_front = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n";
const std::string ply_front = "ply\nformat ascii 1.0\nelement vertex ";
const std::string ply_xyz = "\nproperty float x\nproperty float y\nproperty float z\n";

} // namespace

TEST(HostilePcd, CountsAreCheckedAgainstTheBytes)
{
  for (const char* data : {"ascii", "binary"})
    expectRefusal(readPcd,
                  pcd_front + "POINTS 18446744073709551615\nDATA " + data + "\n",
                  "ends after 0 whole");
  expectRefusal(readPcd,
                pcd_front + "POINTS 1000000000000\nDATA binary_compressed\n" +
                    std::string("\x04\0\0\0\xFF\xFF\xFF\xFF"
                                "abcd",
                                12),
                "unpack to 4294967295");
  expectRefusal(
      readPcd, pcd_front + "COUNT 1 1 99999999\nPOINTS 0\nDATA ascii\n", "65536");
  expectRefusal(readPcd,
                pcd_front + "WIDTH 4294967296\nHEIGHT 4294967296\nDATA ascii\n",
                "usable POINTS");
  expectRefusal(
      readPcd, "FIELDS x y z\nSIZE 4 4\nPOINTS 1\nDATA ascii\n1 2 3\n", "SIZE");
  expectRefusal(readPcd, pcd_front + "POINTS x\nDATA ascii\n", "line 4");
}

// LZF streams by hand: a byte n below 32 precedes n + 1 literal bytes; a larger one
// copies (n >> 5) + 2 bytes (7 << 5: a further byte is added to that count) from as
// many bytes back as its lower five bits and the last byte say, less one.
TEST(HostilePcd, CompressedBytesStayWithinTheirBounds)
{
  const auto file = [](const std::string& packed, int points) {
    const char sizes[8] = {
        static_cast<char>(packed.size()), 0, 0, 0, static_cast<char>(12 * points)};
    return pcd_front + "POINTS " + std::to_string(points) +
           "\nDATA binary_compressed\n" + std::string(sizes, 8) + packed;
  };
  const std::string zeros(4, '\0');
  const std::string one = "\x03" + zeros;
  const std::string copy_8 = std::string("\xC0\x03", 2);
  const Cloud whole = parse(readPcd, file(one + copy_8, 1));
  ASSERT_EQ(whole.points.size(), 1U);
  EXPECT_EQ(whole.points[0], linelet::Point(0, 0, 0));
  EXPECT_EQ(parse(readPcd, file("", 0)).points.size(), 0U);
  expectRefusal(readPcd, file(one, 0), "damaged");

  const std::string copy_9 = std::string("\xE0\0\x03", 3);
  const std::map<std::string, std::string> damaged = {
      {"nothing", ""},
      {"literal bytes that are cut", "\x0B" + zeros},
      {"no distance", one + "\xC0"},
      {"no length", one + "\xE0"},
      {"a length but no distance", one + std::string("\xE0\0", 2)},
      {"too few bytes", one},
      {"too many bytes", one + copy_9},
      {"too many literal bytes", one + copy_8 + one},
      {"a copy from before the first byte", std::string("\xC0\0", 2)},
      {"a copy from far before the first byte", one + "\xDF\xFF"}};
  for (const auto& [what, packed] : damaged) {
    SCOPED_TRACE(what);
    expectRefusal(readPcd, file(packed, 1), "damaged");
  }
}

TEST(HostilePcd, LosesOnlyTheCutPoint)
{
  std::vector<std::string> warnings;
  const std::string text = pcd_front + "POINTS 3\nDATA ascii\n1 2 3\n4 5 6\n7 8";
  EXPECT_NE(refusal(readPcd, text), "");
  EXPECT_EQ(parse(readPcd, text, &warnings).points.size(), 2U);
  EXPECT_EQ(warnings.size(), 1U);
}

TEST(HostilePly, CountsAreCheckedAgainstTheBytes)
{
  expectRefusal(readPly,
                ply_front + "999999999999" + ply_xyz + "end_header\n1 2 3\n",
                "after 1 whole");
  expectRefusal(readPly,
                "ply\nformat binary_little_endian 1.0\nelement face 4000000000\n"
                "property list uchar int v\nelement vertex 1" +
                    ply_xyz + "end_header\n\xFF",
                "before the vertices");
  expectRefusal(readPly, ply_front + "-1" + ply_xyz + "end_header\n", "usable count");
  expectRefusal(readPly, ply_front + "1" + ply_xyz, "end_header");
  expectRefusal(readPly, ply_front + "1" + ply_xyz + "end_header\n1 2 a\n", "line 8");
}

TEST(Ply, ListsAndElementsBeforeTheVerticesAreSteppedOver)
{
  const std::string text =
      "ply\nformat ascii 1.0\nelement face 2\nproperty list uchar int v\n"
      "element vertex 2\nproperty float x\nproperty list uchar int n\nproperty float "
      "y\n"
      "property float z\nend_header\n3 0 1 2\n0\n1 2 8 9 2 3\n4 0 5 6\n";
  const Cloud cloud = parse(readPly, text);
  ASSERT_EQ(cloud.points.size(), 2U);
  EXPECT_EQ(cloud.points[0], linelet::Point(1, 2, 3));
  EXPECT_EQ(cloud.points[1], linelet::Point(4, 5, 6));
}

TEST(Ply, BigEndianIsReadAlike)
{
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement face 1\n"
      "property list uchar short v\nelement vertex 1\nproperty double x\n"
      "property short y\nproperty int z\nend_header\n";
  bytes += std::string("\x02\0\x01\0\x02", 5);
  bytes += std::string("\x3F\xF8\0\0\0\0\0\0", 8); // 1.5
  bytes += std::string("\xFF\xFE\0\x01\0\0", 6);   // -2, 65536
  const Cloud cloud = parse(readPly, bytes);
  ASSERT_EQ(cloud.points.size(), 1U);
  EXPECT_EQ(cloud.points[0] + cloud.shift, linelet::Point(1.5, -2, 65536));
}

TEST(Text, SeparatorsHeadersAndCommentsAreRecognized)
{
  for (const char* text :
       {"1 2 3 7\n4 5 6 8\n",
        "1,2,3,7\r\n4,5,6,8\r\n",
        "1;2;3;7\n4;5;6;8",
        "\t1\t2\t3\t7\n\n4\t5\t6\t8\n",
        "# a remark\nx y z a\n1 2 3 7\n4 5 6 8\n",
        "//X Y Z a\n1 2 3 7\n# in between\n4 5 6 8\n",
        "\xEF\xBB\xBF\"X\", \"Y\", \"Z\", \"a\"\n1, 2, 3, 7\n4,5,6,8,\n",
        "a,z,y,x\n7,3,2,1\n8,6,5,4\n"}) {
    SCOPED_TRACE(text);
    const Cloud cloud = parse(readText, text);
    ASSERT_EQ(cloud.points.size(), 2U);
    EXPECT_EQ(cloud.points[1], linelet::Point(4, 5, 6));
    ASSERT_EQ(cloud.columns.size(), 1U);
    EXPECT_EQ(valueAt(cloud.columns[0], 1), 8);
  }
}

TEST(Text, MistakesAreNamedByLine)
{
  expectRefusal(readText, "1 2 3\n4 x 6\n7 8 9\n", "line 2: 'x'");
  expectRefusal(readText, "1 2 3\n4 5\n7 8 9\n", "line 2: there are 2");
  expectRefusal(readText, "", "empty");
  expectRefusal(readText, "# nothing\n", "'x'");
  expectRefusal(readText, "1\n2\n", "line 1");
  expectRefusal(readText, "1 2 3\n4 5", "line 2");
  std::vector<std::string> warnings;
  EXPECT_EQ(parse(readText, "1 2 3\n4 5", &warnings).points.size(), 1U);
  EXPECT_EQ(warnings.size(), 1U);
}

TEST(Text, NumbersKeepWhatTheySay)
{
  const Cloud cloud = parse(
      readText, "x,y,z,id,gap\n689000.125,+2e3,nan,9007199254740993,1\n1e6,0,0,1,\n");
  EXPECT_EQ(cloud.shift.x() + cloud.points[0].x(), 689000.125);
  EXPECT_EQ(cloud.shift.y() + cloud.points[0].y(), 2000);
  EXPECT_TRUE(std::isnan(cloud.points[0].z()));
  // above 2^53, where doubles skip
  EXPECT_EQ(std::get<std::vector<std::int64_t>>(cloud.find("id")->values)[0],
            9007199254740993);
  EXPECT_TRUE(std::isnan(valueAt(*cloud.find("gap"), 1)));
}

TEST(Obj, VerticesAreReadAndOthersLeft)
{
  const Cloud cloud =
      parse(readObjVertices, "# c\nv 1 2 3\nvn 9 9 9\nv 4 5 6 0.1 0.2 0.3\nf 1 2 1\n");
  ASSERT_EQ(cloud.points.size(), 2U);
  expectRefusal(readObjVertices, "v 1 2\n", "line 1");
  expectRefusal(readObjVertices, "f 1 2 3\n", "no vertices");
}
