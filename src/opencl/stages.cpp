// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "stages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include <linelet/features/point_types.h>

namespace linelet::opencl {

namespace {

constexpr std::size_t group = 256;
constexpr std::size_t sort_group = 128; // GROUP of sort.cl
constexpr double margin = 2;            // empty cells beyond the points

static_assert(sizeof(PointDistributionTensor) == 19 * sizeof(float),
              "shapes.cl writes 18 floats and a count");

/** \brief The chosen points as the device takes them. */
struct Staging {
  std::vector<cl_int> cells;     // 4 a point
  std::vector<float> offsets;    // 3 a point
  std::vector<double> positions; // 3 a point

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

template <class T>
cl::Buffer
upload(const Context& context, const std::vector<T>& values)
{
  const std::size_t bytes = values.size() * sizeof(T);
  cl::Buffer buffer = context.buffer(bytes);
  if (bytes > 0)
    context.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, values.data());
  return buffer;
}

void
run(const Context& context,
    const cl::Kernel& kernel,
    std::size_t items,
    std::size_t group_size = group)
{
  context.queue().enqueueNDRangeKernel(
      kernel,
      cl::NullRange,
      cl::NDRange((items + group_size - 1) / group_size * group_size),
      cl::NDRange(group_size));
}

template <class... Arguments>
void
setArguments(cl::Kernel& kernel, const Arguments&... arguments)
{
  cl_uint number = 0;
  (kernel.setArg(number++, arguments), ...);
}

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
    // A sliver more than the radius, so that rounding never puts a neighbour two cells
    // off.
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

std::string
tensorDefinitions(Centroid centroid,
                  const Weighting& tensor_weight,
                  const Weighting& centroid_weight)
{
  std::ostringstream text;
  text.precision(9);
  text << std::showpoint << "-DCENTROID=" << static_cast<int>(centroid);
  const auto define =
      [&](const char* name, const char letter, const Weighting& weight) {
        text << " -D" << name << '=' << static_cast<int>(weight.kernel()) << " -D"
             << letter << "_FIRST=" << weight.parameters()[0] << "f -D" << letter
             << "_SECOND=" << weight.parameters()[1] << 'f';
      };
  define("TENSOR_WEIGHT", 'W', tensor_weight);
  define("CENTROID_WEIGHT", 'C', centroid_weight);
  return text.str();
}

DeviceTensors
computeTensors(Context& context, const std::string& definitions, const TensorJob& job)
{
  const bool exact = context.device().double_precision;
  const auto cell_size = static_cast<cl_float>(job.frame.cell_size);
  cl::Buffer xyz[3];
  for (cl::Buffer& axis : xyz) {
    // Lanes beyond the last point are read, and weighted by 0: they must be finite.
    const std::size_t bytes = (job.points.count + context.lanes()) * sizeof(float);
    axis = context.buffer(bytes);
    context.queue().enqueueFillBuffer(axis, 0.0F, 0, bytes);
  }
  cl::Kernel gather = context.kernel("gatherPoints");
  setArguments(gather,
               job.point_keys,
               job.points.count,
               job.layout,
               job.points.offsets,
               job.points.cells,
               cell_size,
               xyz[0],
               xyz[1],
               xyz[2]);
  run(context, gather, job.points.count);

  DeviceTensors result;
  const std::vector<float> float_radii(job.radii.begin(), job.radii.end());
  result.radii = upload(context, float_radii);
  result.stride =
      (job.queries.count + context.lanes() - 1) / context.lanes() * context.lanes();
  result.components = context.buffer(6 * result.stride * sizeof(float));
  result.counts = context.buffer(job.queries.count * sizeof(cl_uint));

  cl::Kernel kernel = context.kernel("tensors", definitions);
  setArguments(kernel,
               job.query_keys,
               job.queries.count,
               job.layout,
               job.table.query_slot,
               job.table.places,
               job.queries.offsets,
               job.queries.cells,
               result.radii,
               cell_size,
               xyz[0],
               xyz[1],
               xyz[2],
               result.stride,
               result.components,
               result.counts);
  const cl::Buffer exact_radii = exact ? upload(context, job.radii) : cl::Buffer();
  if (exact) {
    constexpr cl_uint next = 15;
    kernel.setArg(next, job.point_keys);
    kernel.setArg(next + 1, job.points.positions);
    kernel.setArg(next + 2, job.queries.positions);
    kernel.setArg(next + 3, exact_radii);
  }
  run(context, kernel, job.queries.count);
  context.queue().finish();
  return result;
}

cl::Buffer
computeShapes(Context& context,
              const DeviceTensors& tensors,
              const cl::Buffer& query_keys,
              std::size_t queries,
              const KeyLayout& layout)
{
  cl::Buffer records = context.buffer(queries * sizeof(PointDistributionTensor));
  cl::Kernel kernel = context.kernel("shapes");
  setArguments(kernel,
               query_keys,
               static_cast<cl_uint>(queries),
               layout.index_bits,
               tensors.radii,
               tensors.stride,
               tensors.components,
               tensors.counts,
               records);
  run(context, kernel, (queries + context.lanes() - 1) / context.lanes());
  return records;
}

} // namespace linelet::opencl
