// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <numeric>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include "stages.h"

// Each kernel alone against the same thing done on the host.

using namespace linelet;
using namespace linelet::opencl;

namespace {

class Stages : public ::testing::Test {
protected:
  void
  SetUp() override
  {
    if (devices().empty())
      GTEST_SKIP() << "OpenCL has no device here";
    context = std::make_unique<Context>();
  }

  std::vector<Entry>
  download(const cl::Buffer& buffer, std::size_t count) const
  {
    std::vector<Entry> entries(count);
    context->queue().enqueueReadBuffer(
        buffer, CL_TRUE, 0, count * sizeof(Entry), entries.data());
    return entries;
  }

  std::unique_ptr<Context> context;
  boost::random::mt19937 random{7};
};

bool
before(const Entry& a, const Entry& b)
{
  return a.key != b.key ? a.key < b.key : a.index < b.index;
}

} // namespace

TEST_F(Stages, SortOrdersByKeyAndKeepsEveryEntry)
{
  for (const std::size_t count : {1u, 2u, 511u, 512u, 513u, 5000u, 70000u}) {
    SCOPED_TRACE(count);
    const std::size_t padded = paddedCount(count);
    // Few different keys, so that equal ones are many.
    boost::random::uniform_int_distribution<std::uint64_t> key(0, count / 3);
    std::vector<Entry> entries(padded);
    for (std::size_t i = 0; i < padded; ++i)
      entries[i] = {i < count ? key(random) : ~cl_ulong{0}, static_cast<cl_uint>(i), 0};
    const cl::Buffer buffer = context->buffer(padded * sizeof(Entry));
    context->queue().enqueueWriteBuffer(
        buffer, CL_TRUE, 0, padded * sizeof(Entry), entries.data());
    sortEntries(*context, buffer, padded);
    const std::vector<Entry> sorted = download(buffer, padded);
    std::sort(entries.begin(), entries.end(), before);
    for (std::size_t i = 0; i < padded; ++i) {
      ASSERT_EQ(sorted[i].key, entries[i].key) << "at " << i;
      ASSERT_EQ(sorted[i].index, entries[i].index) << "at " << i;
    }
  }
}

TEST_F(Stages, RunsHoldEveryPointWithinTheRadius)
{
  // Wide enough along x that runs cross chunks of cells.
  boost::random::uniform_real_distribution<double> unit(0, 1);
  Points points;
  for (int i = 0; i < 3000; ++i)
    points.emplace_back(200 * unit(random), 4 * unit(random), 3 * unit(random));
  Indices all(points.size());
  std::iota(all.begin(), all.end(), 0u);
  const double radius = 1.1;
  const CellFrame frame(points, all, radius);
  SortedCells cells = uploadPoints(*context, points, all, frame);
  sortCells(*context, cells);
  const RunTable table = neighbourRuns(*context, cells, cells);
  const std::vector<Entry> entries = download(cells.entries, points.size());
  std::vector<cl_uint> slots(points.size());
  context->queue().enqueueReadBuffer(
      table.cell_slot, CL_TRUE, 0, slots.size() * sizeof(cl_uint), slots.data());
  std::vector<cl_uint> runs(table.runs.getInfo<CL_MEM_SIZE>() / sizeof(cl_uint));
  context->queue().enqueueReadBuffer(
      table.runs, CL_TRUE, 0, runs.size() * sizeof(cl_uint), runs.data());

  std::size_t first_of_cell = 0, checked = 0;
  for (std::size_t place = 0; place < points.size(); ++place) {
    if (entries[place].key != entries[first_of_cell].key)
      first_of_cell = place;
    if (place % 37 != 0)
      continue;
    std::vector<cl_uint> found;
    for (std::size_t row = 0; row < 25; ++row) {
      const cl_uint* run = &runs[3 * (25 * slots[first_of_cell] + row)];
      EXPECT_LE(run[0], run[1]);
      EXPECT_LE(run[1], run[2]);
      for (cl_uint p = run[0]; p < run[2]; ++p)
        found.push_back(entries[p].index);
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end())
        << "a point stands in two runs";
    const Point& query = points[entries[place].index];
    for (std::size_t i = 0; i < points.size(); ++i)
      if ((points[i] - query).norm() <= radius) {
        EXPECT_TRUE(
            std::binary_search(found.begin(), found.end(), static_cast<cl_uint>(i)));
        ++checked;
      }
  }
  EXPECT_GT(checked, 200u);
}

TEST_F(Stages, WeightsAreThoseOfWeighting)
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
    for (std::size_t i = 0; i < count; ++i)
      worst = std::max(worst, std::abs(weighting(double{x[i]}) - double{w[i]}));
    // sph-5 is as large as 66, everything else about 1.
    EXPECT_LT(worst, entry.first == Kernel::Sph5 ? 2e-4 : 5e-6);
  }
}
