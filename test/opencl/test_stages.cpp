// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <numeric>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <Eigen/QR>
#include <gtest/gtest.h>

#include <linelet/features/tensor_estimation.h>

#include "error_names.h"
#include "tensor_stages.h"

// Each kernel alone, compared with the same computation on the host.

using namespace linelet;
using namespace linelet::opencl;

namespace {

/** \brief With the device's preferred vector width, and with the single lane of
 * GPUs. */
class Stages : public ::testing::TestWithParam<unsigned> {
protected:
  void
  SetUp() override
  {
    if (devices().empty())
      GTEST_SKIP() << "no OpenCL device was found";
    context = std::make_unique<Context>("", GetParam());
  }

  template <class T>
  std::vector<T>
  download(const cl::Buffer& buffer, std::size_t count) const
  {
    std::vector<T> values(count);
    context->queue().enqueueReadBuffer(
        buffer, CL_TRUE, 0, count * sizeof(T), values.data());
    return values;
  }

  template <class T>
  cl::Buffer
  upload(const std::vector<T>& values) const
  {
    cl::Buffer buffer = context->buffer(values.size() * sizeof(T));
    context->queue().enqueueWriteBuffer(
        buffer, CL_TRUE, 0, values.size() * sizeof(T), values.data());
    return buffer;
  }

  Points
  box(std::size_t count, const Point& extent)
  {
    boost::random::uniform_real_distribution<double> unit(0, 1);
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = unit(random), y = unit(random), z = unit(random);
      points.emplace_back(extent.cwiseProduct(Point(x, y, z)));
    }
    return points;
  }

  std::unique_ptr<Context> context;
  boost::random::mt19937 random{7};
};

Indices
allOf(const Points& points)
{
  Indices all(points.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

/** \brief All points, each also a query. */
Slab
slabOf(Context& context, const Points& points, double radius)
{
  const Indices all = allOf(points);
  const CellFrame frame(points, all, radius);
  Slab slab{frame, frame.layout(points.size()), {}, {}, {}, {}, {}};
  slab.points = slab.queries = uploadPoints(context, points, all, frame, 1);
  slab.point_keys = slab.query_keys =
      sortedKeys(context, slab.points, frame, slab.layout);
  slab.table = assignSlots(context, slab.query_keys, points.size(), slab.layout);
  fillTable(context,
            slab.table,
            slab.query_keys,
            slab.point_keys,
            points.size(),
            slab.layout);
  return slab;
}

} // namespace

TEST_P(Stages, SortOrdersKeysOfAnyNumberOfBlocks)
{
  for (const std::size_t blocks :
       {1u, 2u, 3u, 4u, 5u, 7u, 8u, 13u, 16u, 31u, 45u, 64u}) {
    SCOPED_TRACE(blocks);
    const std::size_t count = blocks * sort_block;
    // All, few different ones, ascending, descending.
    for (const std::uint64_t range : {~std::uint64_t{0}, std::uint64_t{5}}) {
      boost::random::uniform_int_distribution<std::uint64_t> key(0, range);
      std::vector<cl_ulong> keys(count);
      for (cl_ulong& k : keys)
        k = key(random);
      for (int order = 0; order < 3; ++order) {
        const cl::Buffer buffer = upload(keys);
        sortKeys(*context, buffer, count);
        const auto sorted = download<cl_ulong>(buffer, count);
        std::sort(keys.begin(), keys.end());
        ASSERT_TRUE(sorted == keys) << "order " << order;
        if (order == 1)
          std::reverse(keys.begin(), keys.end());
      }
    }
  }
}

TEST_P(Stages, KeysOrderPointsByRowThenAlongXThenByIndex)
{
  const Points points = box(5000, Point(30, 7, 3));
  const Indices all = allOf(points);
  const CellFrame frame(points, all, 0.9);
  const KeyLayout layout = frame.layout(points.size());
  const DevicePoints on_device = uploadPoints(*context, points, all, frame, 1);
  const auto keys =
      download<cl_ulong>(sortedKeys(*context, on_device, frame, layout), points.size());
  const std::uint64_t mask = (std::uint64_t{1} << layout.index_bits) - 1;
  std::vector<bool> seen(points.size(), false);
  const auto cellAlong = [&](std::size_t i, int axis) {
    return std::floor((points[i][axis] - frame.corner[axis]) / frame.cell_size);
  };
  for (std::size_t place = 0; place < keys.size(); ++place) {
    const std::size_t i = keys[place] & mask;
    ASSERT_LT(i, points.size());
    EXPECT_FALSE(seen[i]) << "point " << i << " appears at two places";
    seen[i] = true;
    if (place == 0)
      continue;
    const std::size_t before = keys[place - 1] & mask;
    ASSERT_LE(cellAlong(before, 2), cellAlong(i, 2));
    if (cellAlong(before, 2) < cellAlong(i, 2))
      continue;
    ASSERT_LE(cellAlong(before, 1), cellAlong(i, 1));
    if (cellAlong(before, 1) < cellAlong(i, 1))
      continue;
    // Bins are a quarter of a cell wide.
    ASSERT_LT(points[before].x(), points[i].x() + frame.cell_size / 4 * (1 + 1e-5));
  }
}

TEST_P(Stages, TableHoldsEveryPointWithinTheRadius)
{
  // Wide enough along x that rows cross chunks of cells.
  const Points points = box(3000, Point(200, 4, 3));
  const double radius = 1.1;
  const Slab slab = slabOf(*context, points, radius);
  const CellTable& table = slab.table;
  const auto keys = download<cl_ulong>(slab.point_keys, points.size());
  const auto slots = download<cl_uint>(table.query_slot, points.size());
  const auto places = download<cl_uint>(table.places, table.bytes() / sizeof(cl_uint));
  const std::uint64_t mask = (std::uint64_t{1} << slab.layout.index_bits) - 1;

  std::size_t checked = 0;
  for (std::size_t place = 0; place < points.size(); place += 37) {
    ASSERT_LT(slots[place], table.slots);
    std::vector<std::size_t> found;
    for (std::size_t row = 0; row < CellTable::rows; ++row) {
      const cl_uint* bins =
          &places[CellTable::row_places * (CellTable::rows * slots[place] + row)];
      EXPECT_TRUE(std::is_sorted(bins, bins + CellTable::row_places));
      for (cl_uint p = bins[0]; p < bins[CellTable::row_places - 1]; ++p)
        found.push_back(keys[p] & mask);
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end())
        << "a point is in two rows";
    const Point& query = points[keys[place] & mask];
    for (std::size_t i = 0; i < points.size(); ++i)
      if ((points[i] - query).norm() <= radius) {
        EXPECT_TRUE(std::binary_search(found.begin(), found.end(), i));
        ++checked;
      }
  }
  EXPECT_GT(checked, 200u);
}

TEST_P(Stages, TensorsAreThoseOfTheNeighbors)
{
  const Points points = box(700, Point(5, 4, 3));
  const Slab slab = slabOf(*context, points, 0.8);
  const DeviceTensors tensors = computeTensors(
      *context,
      tensorDefinitions(Centroid::QueryPoint, Kernel::Const, Kernel::Const),
      slab,
      std::vector<double>(points.size(), 0.8));
  const auto keys = download<cl_ulong>(slab.query_keys, points.size());
  const auto components = download<float>(tensors.components, 6 * tensors.stride);
  const auto counts = download<cl_uint>(tensors.counts, points.size());
  for (std::size_t place = 0; place < points.size(); ++place) {
    const Point& query = points[keys[place] & ((1u << slab.layout.index_bits) - 1)];
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    cl_uint count = 0;
    for (const Point& p : points)
      if ((p - query).squaredNorm() <= 0.8 * 0.8) {
        sum += (p - query) * (p - query).transpose();
        ++count;
      }
    ASSERT_EQ(counts[place], count);
    sum /= count;
    const double expected[] = {
        sum(0, 0), sum(0, 1), sum(0, 2), sum(1, 1), sum(1, 2), sum(2, 2)};
    for (std::size_t k = 0; k < 6; ++k)
      ASSERT_NEAR(components[k * tensors.stride + place], expected[k], 1e-6);
  }
}

TEST_P(Stages, NearestSquaresAreThoseOfSortedDistances)
{
  // Denser and denser along x, and long enough to cross chunks of cells.
  Points points = box(1500, Point(1, 3, 2));
  for (Point& p : points)
    p.x() = 60 * p.x() * p.x() * p.x();
  const double reach = 1.5;
  const Slab slab = slabOf(*context, points, reach);
  std::vector<cl_uint> wanted;
  for (std::size_t i = 0; i < points.size(); ++i)
    wanted.push_back(static_cast<cl_uint>(1 + i % 60 + (i % 7 == 0 ? 150 : 0)));
  const std::vector<double> squares = nearestSquares(*context, slab, wanted);
  std::size_t found = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<double> sorted;
    for (const Point& p : points)
      sorted.push_back((p - points[i]).squaredNorm());
    std::sort(sorted.begin(), sorted.end());
    const double expected = sorted[wanted[i] - 1];
    if (expected > reach * reach * (1 - 1e-5)) {
      EXPECT_TRUE(std::isnan(squares[i])) << i;
    }
    else {
      ASSERT_EQ(squares[i], expected) << i;
      ++found;
    }
  }
  EXPECT_GT(found, 500u);
  EXPECT_LT(found, 1400u);
}

TEST_P(Stages, ShapesAreThoseOfTheEigenAnalysisInDouble)
{
  // Wires, sheets and balls in any direction and of any size, including exact zeros and
  // equal eigenvalues.
  boost::random::uniform_real_distribution<double> unit(-1, 1);
  std::vector<SymmetricTensor> given;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Matrix3d random_matrix =
        Eigen::Matrix3d::NullaryExpr([&] { return unit(random); });
    const Eigen::Matrix3d turned =
        random_matrix.householderQr().householderQ() * Eigen::Matrix3d::Identity();
    const double small = std::pow(10.0, -4 * std::abs(unit(random)));
    const Eigen::Vector3d values =
        std::pow(10.0, 3 * unit(random)) *
        Eigen::Vector3d(i % 5 == 0 ? 0 : small * small, i % 3 == 0 ? 1 : small, 1);
    const Eigen::Matrix3d t = turned * values.asDiagonal() * turned.transpose();
    given.push_back({t(0, 0), t(0, 1), t(0, 2), t(1, 1), t(1, 2), t(2, 2)});
  }
  given.push_back({1, 0, 0, 1, 0, 1});
  given.push_back({0, 0, 0, 2, 0, 0});
  given.push_back({0, 0, 0, 0, 0, 0});
  const auto count = static_cast<cl_uint>(given.size());

  DeviceTensors tensors;
  tensors.stride = count + 16 - count % 16;
  std::vector<float> components(6 * tensors.stride);
  std::vector<cl_ulong> keys;
  for (std::size_t i = 0; i < count; ++i) {
    const SymmetricTensor& t = given[i];
    const double entries[] = {t.xx, t.xy, t.xz, t.yy, t.yz, t.zz};
    for (std::size_t k = 0; k < 6; ++k)
      components[k * tensors.stride + i] = static_cast<float>(entries[k]);
    keys.push_back(count - 1 - i); // records are stored by index, not by position
  }
  tensors.radii = upload(std::vector<float>(count, 1.0F));
  tensors.components = upload(components);
  tensors.counts = upload(std::vector<cl_uint>(count, 42));
  Slab slab{CellFrame({}, {}, 1), {1, 1, 20}, {}, {}, {}, upload(keys), {}};
  slab.queries.count = count;
  auto records =
      download<PointDistributionTensor>(computeShapes(*context, tensors, slab), count);
  std::reverse(records.begin(), records.end());
  EXPECT_TRUE(std::isnan(records.back().linearity));
  EXPECT_TRUE(std::isnan(records.back().xx));
  for (std::size_t i = 0; i + 1 < count; ++i) {
    SCOPED_TRACE(i);
    const PointDistributionTensor& r = records[i];
    const PointDistributionTensor e = recordOf(given[i], 0, 42);
    ASSERT_EQ(r.neighbors, 42u);
    ASSERT_NEAR(r.linearity, e.linearity, 5e-6);
    ASSERT_NEAR(r.planarity, e.planarity, 5e-6);
    ASSERT_NEAR(r.sphericity, e.sphericity, 5e-6);
    ASSERT_NEAR(r.lambda1, e.lambda1, 2e-6 * e.lambda3);
    ASSERT_NEAR(r.lambda2, e.lambda2, 2e-6 * e.lambda3);
    ASSERT_NEAR(r.lambda3, e.lambda3, 2e-6 * e.lambda3);
    // Directions, where there is only one: their sign is part of the contract, except
    // where two components are about equal.
    const auto expectAlong = [&](Eigen::Vector3f a, Eigen::Vector3f b, double gap) {
      EXPECT_NEAR(a.norm(), 1, 1e-5);
      EXPECT_GE(a.maxCoeff(), -a.minCoeff());
      if (gap > 1e-2 * e.lambda3) {
        EXPECT_NEAR(std::abs(a.dot(b)), 1, 1e-5);
      }
    };
    expectAlong({r.major_x, r.major_y, r.major_z},
                {e.major_x, e.major_y, e.major_z},
                e.lambda3 - e.lambda2);
    expectAlong({r.normal_x, r.normal_y, r.normal_z},
                {e.normal_x, e.normal_y, e.normal_z},
                e.lambda2 - e.lambda1);
  }
}

TEST_P(Stages, WeightsAreThoseOfWeighting)
{
  constexpr std::size_t count = 4096;
  std::vector<float> x(count), w(count);
  for (std::size_t i = 0; i < count; ++i)
    x[i] = 1.5F * static_cast<float>(i) / count;
  const cl::Buffer places = context->buffer(count * sizeof(float));
  const cl::Buffer values = context->buffer(count * sizeof(float));
  context->queue().enqueueWriteBuffer(
      places, CL_TRUE, 0, count * sizeof(float), x.data());
  cl::Kernel kernel = context->kernel("weights");
  for (const auto& entry : Names<Kernel>::table) {
    SCOPED_TRACE(std::string(entry.second));
    const Weighting weighting = entry.first == Kernel::FermiDirac
                                    ? Weighting::fermiDirac(0.4, 0.07)
                                : entry.first == Kernel::Step ? Weighting::step(0.45)
                                                              : Weighting(entry.first);
    kernel.setArg(0, static_cast<cl_int>(entry.first));
    kernel.setArg(1, static_cast<float>(weighting.parameters()[0]));
    kernel.setArg(2, static_cast<float>(weighting.parameters()[1]));
    kernel.setArg(3, places);
    kernel.setArg(4, values);
    context->queue().enqueueNDRangeKernel(
        kernel, cl::NullRange, cl::NDRange(count / context->lanes()));
    context->queue().enqueueReadBuffer(
        values, CL_TRUE, 0, count * sizeof(float), w.data());
    double worst = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double expected = weighting(double{x[i]});
      // For unbounded kernels the relative error counts.
      worst = std::max(worst,
                       std::abs(expected - double{w[i]}) /
                           (isUnbounded(entry.first) ? std::max(1.0, expected) : 1));
    }
    // sph-5 is as large as 66, sph-4 as 14, everything else about 1.
    EXPECT_LT(worst,
              entry.first == Kernel::Sph5   ? 2e-4
              : entry.first == Kernel::Sph4 ? 4e-5
                                            : 5e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Lanes, Stages, ::testing::Values(0u, 1u, 8u));

TEST(Errors, HaveTheirOpenClNameAndCode)
{
  EXPECT_STREQ(errorName(CL_OUT_OF_RESOURCES), "CL_OUT_OF_RESOURCES");
  EXPECT_STREQ(errorName(CL_INVALID_WORK_ITEM_SIZE), "CL_INVALID_WORK_ITEM_SIZE");
  // All codes of OpenCL 1.2 but the unused -20 to -29.
  for (cl_int code = -68; code < 0; ++code)
    if (code < -29 || code > -20) {
      EXPECT_EQ(std::string(errorName(code)).substr(0, 3), "CL_") << code;
    }
  const Error error =
      explained(cl::Error(CL_INVALID_KERNEL_ARGS, "the call"), "a device");
  EXPECT_EQ(error.code(), CL_INVALID_KERNEL_ARGS);
  EXPECT_STREQ(error.what(),
               "OpenCL: the call failed on device 'a device' with "
               "CL_INVALID_KERNEL_ARGS (-52)");
}
