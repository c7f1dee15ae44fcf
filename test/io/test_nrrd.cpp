// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Volumes written byte by byte, following teem's definition of the format; one is also
// read with VTK.

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <Eigen/Geometry>

#ifdef LINELET_HAS_VTK_NRRD
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkNrrdReader.h>
#include <vtkPointData.h>
#endif

#include <linelet/io/point_file.h>

#include "file_helpers.h"

using namespace linelet;
using namespace linelet::io;
using namespace linelet::test;

namespace {

template <class T>
std::string
packed(const std::vector<double>& numbers, bool big = false)
{
  std::string bytes;
  for (const double number : numbers) {
    const T value = static_cast<T>(number);
    std::string one(reinterpret_cast<const char*>(&value), sizeof value);
    if (big)
      one.assign(one.rbegin(), one.rend());
    bytes += one;
  }
  return bytes;
}

/** \brief 6 numbers for each of 2 x 3 x 2 samples: number c of sample i, j, k is
 * 1000 c + 100 i + 10 j + k. */
std::vector<double>
sixNumbers()
{
  std::vector<double> numbers;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 2; ++i)
        for (int c = 0; c < 6; ++c)
          numbers.push_back(1000 * c + 100 * i + 10 * j + k);
  return numbers;
}

const std::string six_header = "NRRD0004\n# made by hand\ntype: float\ndimension: 4\n"
                               "sizes: 6 2 3 2\nkinds: 3D-symmetric-matrix space space "
                               "space\nendian: little\nencoding: raw\n"
                               "space dimension: 3\nsome key:=some value\n";

class Nrrd : public testing::Test {
protected:
  Cloud
  read(const std::string& bytes, std::vector<std::string>* warnings = nullptr)
  {
    writeBytes(folder_.file("volume.nrrd"), bytes);
    return readCloud(folder_.file("volume.nrrd"), {}, warnings);
  }

  void
  expectRefusal(const std::string& bytes, const std::string& what)
  {
    try {
      read(bytes);
      FAIL() << "was read; should say: " << what;
    }
    catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos)
          << error.what();
    }
  }

  static double
  value(const Cloud& cloud, const char* name, std::size_t i)
  {
    return valueAt(*cloud.find(name), i);
  }

  Folder folder_;
};

TEST_F(Nrrd, SamplesAreWhereTheHeaderSaysWithTheirTensors)
{
  const Cloud cloud = read(six_header +
                           "space origin: (10,20,30)\n"
                           "space directions: none (2,0,0) (0,0,3) (0,-4,0)\n\n" +
                           packed<float>(sixNumbers()));
  ASSERT_EQ(cloud.points.size(), 12u);
  std::size_t n = 0;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 2; ++i, ++n) {
        EXPECT_LT(
            (cloud.shift + cloud.points[n] - Point(10 + 2 * i, 20 - 4 * k, 30 + 3 * j))
                .norm(),
            1e-12);
        int c = 0;
        for (const char* name : {"xx", "xy", "xz", "yy", "yz", "zz"})
          EXPECT_EQ(value(cloud, name, n), 1000 * c++ + 100 * i + 10 * j + k) << name;
      }
}

TEST_F(Nrrd, BothByteOrdersTextAndEveryPlaceOfTheTensorAxisAreTheSame)
{
  const Cloud raw = read(six_header + "\n" + packed<float>(sixNumbers()));
  const auto expectSame = [&](const Cloud& other, const char* what) {
    ASSERT_EQ(other.points.size(), raw.points.size()) << what;
    for (std::size_t n = 0; n < raw.points.size(); ++n) {
      EXPECT_EQ(other.points[n], raw.points[n]) << what;
      for (const char* name : {"xx", "xy", "xz", "yy", "yz", "zz"})
        EXPECT_EQ(value(other, name, n), value(raw, name, n)) << what;
    }
  };
  const std::string front = "NRRD0005\r\ndimension: 4\r\n";
  const std::string first =
      "sizes: 6 2 3 2\r\nkinds: 3D-symmetric-matrix domain domain "
      "domain\r\n";
  expectSame(read(front + first +
                  "type: double\r\nendian: big\r\nencoding: raw\r\n\r\n" +
                  packed<double>(sixNumbers(), true)),
             "big-endian doubles");
  expectSame(read(front + first +
                  "type: unsigned short\r\nendian: big\r\n"
                  "encoding: raw\r\n\r\n" +
                  packed<std::uint16_t>(sixNumbers(), true)),
             "16 bits");
  std::string text;
  for (const double number : sixNumbers())
    text += std::to_string(static_cast<int>(number)) + (text.size() % 3 ? " " : "\n");
  expectSame(read(front + first + "type: int\r\nencoding: ascii\r\n\r\n" + text),
             "text");
  // With the tensor axis last: all xx, then all xy, ...
  std::vector<double> last;
  const std::vector<double> numbers = sixNumbers();
  for (std::size_t c = 0; c < 6; ++c)
    for (std::size_t n = 0; n < 12; ++n)
      last.push_back(numbers[6 * n + c]);
  expectSame(read(front +
                  "sizes: 2 3 2 6\r\nspace directions: (1,0,0) (0,1,0) (0,0,1) none\r\n"
                  "type: float\r\nendian: little\r\nencoding: raw\r\n\r\n" +
                  packed<float>(last)),
             "the tensor axis last");
}

TEST_F(Nrrd, GzipIsUnpacked)
{
  const std::string raw = packed<float>(sixNumbers());
  writeBytes(folder_.file("data"), raw);
  if (std::system(("gzip -k " + folder_.file("data")).c_str()) != 0)
    GTEST_SKIP() << "there is no gzip";
  std::string header = six_header;
  header.replace(header.find("raw"), 3, "gzip");
  const std::string zipped = bytesOf(folder_.file("data.gz"));
  Cloud cloud;
  try {
    cloud = read(header + "\n" + zipped);
  }
  catch (const FileError& error) {
    if (std::string(error.what()).find("without zlib") != std::string::npos)
      GTEST_SKIP() << error.what();
    throw;
  }
  const Cloud expected = read(six_header + "\n" + raw);
  for (std::size_t n = 0; n < expected.points.size(); ++n)
    EXPECT_EQ(value(cloud, "yz", n), value(expected, "yz", n));
  expectRefusal(header + "\n" + zipped.substr(0, zipped.size() / 2), "numbers");
  std::string damaged = zipped;
  damaged[1] = 'x';
  expectRefusal(header + "\n" + damaged, "damaged");
}

TEST_F(Nrrd, MasksLeaveSamplesOutAndFramesTurnTensors)
{
  // A prolate tensor along x of the frame, which is turned by 90 degrees about z.
  const std::string header = "NRRD0005\ntype: float\ndimension: 4\nsizes: 7 3 1 1\n"
                             "kinds: 3D-masked-symmetric-matrix space space space\n"
                             "endian: little\nencoding: raw\nspace dimension: 3\n"
                             "measurement frame: (0,1,0) (-1,0,0) (0,0,1)\n\n";
  const Cloud cloud =
      read(header + packed<float>({1, 3, 0.5, 0,   1, 0, 1, 0.4, 3, 0, 0,
                                   1, 0, 1,   0.5, 3, 0, 0, 1,   0, 1}));
  ASSERT_EQ(cloud.points.size(), 2u);
  EXPECT_EQ(cloud.points[1].x() + cloud.shift.x(), 2);
  EXPECT_NEAR(value(cloud, "xx", 0), 1, 1e-6);
  EXPECT_NEAR(value(cloud, "yy", 0), 3, 1e-6);
  EXPECT_NEAR(value(cloud, "xy", 0), -0.5, 1e-6);
}

TEST_F(Nrrd, MatricesGiveTheirSymmetricPartAndNumbersAValue)
{
  const std::string start = "NRRD0001\nendian: little\nencoding: raw\ntype: double\n";
  const Cloud matrix = read(start +
                            "dimension: 4\nsizes: 9 1 1 1\n"
                            "kinds: 3D-matrix space space space\n\n" +
                            packed<double>({1, 2, 3, 4, 5, 6, 7, 8, 9}));
  ASSERT_EQ(matrix.points.size(), 1u);
  EXPECT_EQ(value(matrix, "xy", 0), 3);
  EXPECT_EQ(value(matrix, "xz", 0), 5);
  EXPECT_EQ(value(matrix, "yz", 0), 7);
  EXPECT_EQ(value(matrix, "zz", 0), 9);
  const Cloud numbers =
      read(start + "dimension: 3\nsizes: 2 1 2\nspacings: 0.5 1 2\n\n" +
           packed<double>({5, 6, 7, 8}));
  ASSERT_EQ(numbers.points.size(), 4u);
  EXPECT_EQ(value(numbers, "value", 3), 8);
  EXPECT_EQ(numbers.shift + numbers.points[3], Point(0.5, 0, 2));
}

TEST_F(Nrrd, RefusesUnsupportedVolumes)
{
  const std::string data = packed<float>(sixNumbers());
  expectRefusal("", "not an NRRD");
  expectRefusal("NRRD0004\n", "no 'type'");
  expectRefusal("NRRD0004\ntype: block\n\n", "block");
  expectRefusal(six_header + "\n" + data.substr(1), "numbers");
  expectRefusal(six_header + "data file: other.raw\n\n", "data file");
  expectRefusal(six_header + "space directions: none (1,0,0) (0,1,0)\n\n" + data,
                "space directions");
  expectRefusal(six_header + "space directions: none (1,0,0) (0,1,0) (0,x,0)\n\n" +
                    data,
                "space directions");
  expectRefusal(six_header + "space origin: (1,2)\n\n" + data, "space origin");
  expectRefusal(six_header + "sizes: 6 2 0 2\n\n" + data, "size");
  // More than the file can hold, or nonsense.
  expectRefusal(six_header + "sizes: 6 2000 3000 2000\n\n" + data, "size");
  expectRefusal(six_header + "sizes: 6 200 300 200\n\n" + data, "ends after");
  expectRefusal(six_header + "encoding: gzip\nsizes: 6 200 300 200\n\n" + data,
                "numbers");
  expectRefusal(six_header + "encoding: bzip2\n\n" + data, "bzip2");
  expectRefusal(six_header + "sizes: 5 2 3 2\n\n" + data, "components");
  expectRefusal(six_header + "kinds: vector space space space\n\n" + data, "tensor");
}

#ifdef LINELET_HAS_VTK_NRRD
TEST_F(Nrrd, VtkReadsTheSame)
{
  const Cloud cloud = read(six_header +
                           "space directions: none (2,0,0) (0,3,0) (0,0,4)\n"
                           "space origin: (10,20,30)\n\n" +
                           packed<float>(sixNumbers()));
  const vtkNew<vtkNrrdReader> reader;
  reader->SetFileName(folder_.file("volume.nrrd").c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(image->GetNumberOfPoints(), 12);
  vtkDataArray* tensors = image->GetPointData()->GetArray(0);
  ASSERT_NE(tensors, nullptr);
  for (vtkIdType n = 0; n < 12; ++n) {
    const auto i = static_cast<std::size_t>(n);
    EXPECT_LT((Point(image->GetPoint(n)) - cloud.shift - cloud.points[i]).norm(), 1e-9);
    if (tensors->GetNumberOfComponents() == 6)
      EXPECT_EQ(tensors->GetComponent(n, 4), value(cloud, "yz", i));
    else // VTK expands symmetric tensors
      EXPECT_EQ(tensors->GetComponent(n, 5), value(cloud, "yz", i));
  }
}
#endif

} // namespace
