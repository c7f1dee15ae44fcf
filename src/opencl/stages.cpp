// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "stages.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "launch.h"

namespace linelet::opencl {

namespace {

constexpr std::size_t sort_group = 128; // GROUP of sort.cl
constexpr double margin = 2;            // empty cells beyond the points

/** \brief The chosen points as the device takes them. */
struct Staging {
  std::vector<cl_int> cells;     // 4 per point
  std::vector<float> offsets;    // 3 per point
  std::vector<double> positions; // 3 per point

  Staging(const Points& points,
          const Indices& chosen,
          const CellFrame& frame,
          int threads)
      : cells(4 * chosen.size()),
        offsets(3 * chosen.size()),
        positions(3 * chosen.size())
  {
    const auto count = static_cast<std::ptrdiff_t>(chosen.size());
#pragma omp parallel for num_threads(threads)
    for (std::ptrdiff_t k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const Point& point = points[chosen[i]];
      const Point from_corner = point - frame.corner;
      for (int axis = 0; axis < 3; ++axis) {
        // A query outside of the cloud's box keeps its distance from the border cell.
        const double cell = std::clamp(std::floor(from_corner[axis] / frame.cell_size),
                                       margin - 1,
                                       frame.cells[axis] - margin);
        const auto a = static_cast<std::size_t>(axis);
        cells[4 * i + a] = static_cast<cl_int>(cell);
        offsets[3 * i + a] =
            static_cast<float>(from_corner[axis] - cell * frame.cell_size);
        positions[3 * i + a] = point[axis];
      }
    }
  }
};

unsigned
bitsFor(std::size_t count)
{
  unsigned bits = 1;
  while ((std::size_t{1} << bits) < count)
    ++bits;
  return bits;
}

} // namespace

CellFrame::CellFrame(const Points& points, const Indices& chosen, double radius)
    // Slightly more than the radius, so that rounding never puts a neighbor two cells
    // away.
    : cell_size(radius * (1 + 1e-6))
{
  if (chosen.empty())
    return;
  Point low = points[chosen.front()], high = low;
  for (const Index i : chosen) {
    low = low.cwiseMin(points[i]);
    high = high.cwiseMax(points[i]);
  }
  corner = low.array() - margin * cell_size;
  cells = ((high - low).array() / cell_size).floor() + 1 + 2 * margin;
}

bool
CellFrame::fits(std::size_t count) const
{
  constexpr double bins = 4; // BINS of cells.cl
  constexpr double most = std::numeric_limits<cl_int>::max();
  // One bit is left over: no key is as large as those that fill up the last block.
  return cells.maxCoeff() < most &&
         std::log2(cells.prod() * bins) + bitsFor(count) < 63;
}

KeyLayout
CellFrame::layout(std::size_t count) const
{
  return {static_cast<cl_uint>(cells[0]),
          static_cast<cl_uint>(cells[1]),
          static_cast<cl_uint>(bitsFor(count))};
}

DevicePoints
uploadPoints(Context& context,
             const Points& points,
             const Indices& chosen,
             const CellFrame& frame,
             int threads)
{
  const Staging staging(points, chosen, frame, threads);
  DevicePoints result;
  result.count = static_cast<cl_uint>(chosen.size());
  result.cells = upload(context, staging.cells);
  result.offsets = upload(context, staging.offsets);
  result.positions = context.device().double_precision
                         ? upload(context, staging.positions)
                         : context.buffer(1);
  return result;
}

cl::Buffer
sortedKeys(Context& context,
           const DevicePoints& points,
           const CellFrame& frame,
           const KeyLayout& layout)
{
  const std::size_t count = (points.count + sort_block - 1) / sort_block * sort_block;
  cl::Buffer keys = context.buffer(count * sizeof(cl_ulong));
  cl::Kernel kernel = context.kernel("cellKeys");
  setArguments(kernel,
               points.cells,
               points.offsets,
               points.count,
               static_cast<cl_float>(1 / frame.cell_size),
               layout,
               keys);
  run(context, kernel, count);
  sortKeys(context, keys, count);
  return keys;
}

void
sortKeys(Context& context, const cl::Buffer& keys, std::size_t count)
{
  constexpr std::size_t fused = 8; // FUSED of sort.cl
  const std::size_t groups = count / sort_block;
  const std::size_t at_once = context.lanes() == 1 ? 1 : 8; // KEYS of sort.cl
  const auto uint = [](std::size_t value) { return static_cast<cl_uint>(value); };
  cl::Kernel blocks = context.kernel("sortBlocks");
  setArguments(blocks, keys);
  run(context, blocks, groups * sort_group, sort_group);
  cl::Kernel flip = context.kernel("flip"), merge = context.kernel("merge");
  cl::Kernel merge_blocks = context.kernel("mergeBlocks");
  setArguments(merge_blocks, keys);
  for (std::size_t size = 2 * sort_block; size < 2 * count; size *= 2) {
    // One work-item for every FUSED vectors of the whole or begun sequences.
    const std::size_t items = (count + size - 1) / size * size / fused / at_once;
    // Steps left until all strides stay inside a block.
    std::size_t left = 1, stride = size / 4;
    while (sort_block << left < size)
      ++left;
    const auto take = [&] {
      const std::size_t steps = std::min<std::size_t>(left, 3);
      left -= steps;
      return steps;
    };
    const std::size_t first = take();
    setArguments(flip, keys, uint(count), uint(size), uint(first));
    run(context, flip, items);
    stride >>= first - 1;
    while (left > 0) {
      const std::size_t steps = take();
      setArguments(merge, keys, uint(count), uint(stride), uint(steps));
      run(context, merge, items);
      stride >>= steps;
    }
    run(context, merge_blocks, groups * sort_group, sort_group);
  }
}

CellTable
assignSlots(Context& context,
            const cl::Buffer& query_keys,
            std::size_t queries,
            const KeyLayout& layout)
{
  CellTable table;
  table.query_slot = context.buffer(queries * sizeof(cl_uint));
  table.slot_place = context.buffer(queries * sizeof(cl_uint));
  const cl::Buffer counter = context.buffer(sizeof(cl_uint));
  context.queue().enqueueWriteBuffer(
      counter, CL_TRUE, 0, sizeof table.slots, &table.slots);
  cl::Kernel kernel = context.kernel("assignSlots");
  setArguments(kernel,
               query_keys,
               static_cast<cl_uint>(queries),
               layout,
               table.query_slot,
               table.slot_place,
               counter);
  run(context, kernel, queries);
  context.queue().enqueueReadBuffer(
      counter, CL_TRUE, 0, sizeof table.slots, &table.slots);
  return table;
}

void
fillTable(Context& context,
          CellTable& table,
          const cl::Buffer& query_keys,
          const cl::Buffer& point_keys,
          std::size_t points,
          const KeyLayout& layout)
{
  table.places = context.buffer(table.bytes());
  cl::Kernel kernel = context.kernel("cellTable");
  setArguments(kernel,
               query_keys,
               table.slot_place,
               table.slots,
               layout,
               point_keys,
               static_cast<cl_uint>(points),
               table.places);
  run(context, kernel, table.slots * CellTable::rows);
}

} // namespace linelet::opencl
