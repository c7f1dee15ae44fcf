// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "stages.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace linelet::opencl {

namespace {

constexpr std::size_t group = 256; // BLOCK of sort.cl
constexpr std::size_t rows = 25;   // ROWS of cells.cl
constexpr double reach = 2;        // REACH of cells.cl

/** \brief The chosen points as the device takes them. */
struct Staging {
  std::vector<cl_int> cells;     // 4 a point
  std::vector<float> offsets;    // 3 a point
  std::vector<double> positions; // 3 a point

  Staging(const Points& points, const Indices& chosen, const CellFrame& frame)
      : cells(4 * chosen.size()),
        offsets(3 * chosen.size()),
        positions(3 * chosen.size())
  {
    const double most = std::ldexp(1.0, 21) - reach - 2; // KEY_BITS of cells.cl
    const auto count = static_cast<std::ptrdiff_t>(chosen.size());
#pragma omp parallel for
    for (std::ptrdiff_t k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const Point& point = points[chosen[i]];
      const Point from_corner = point - frame.corner;
      for (int axis = 0; axis < 3; ++axis) {
        // A query outside of the cloud's box keeps its distance from the border cell.
        const double cell =
            std::clamp(std::floor(from_corner[axis] / frame.cell_size), 0.0, most);
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
run(const Context& context, const cl::Kernel& kernel, std::size_t items)
{
  context.queue().enqueueNDRangeKernel(
      kernel, cl::NullRange, cl::NDRange((items + group - 1) / group * group), group);
}

} // namespace

CellFrame::CellFrame(const Points& points, const Indices& chosen, double radius)
    : cell_size(radius / reach)
{
  if (chosen.empty())
    return;
  Point low = points[chosen.front()], high = low;
  for (const Index i : chosen) {
    low = low.cwiseMin(points[i]);
    high = high.cwiseMax(points[i]);
  }
  // A sliver more than the radius, so that rounding never puts a neighbour two cells
  // off.
  const double extent = (high - low).maxCoeff();
  cell_size = std::max(radius / reach * (1 + 1e-6), std::ldexp(extent, -20));
  corner = low.array() - reach * cell_size;
}

std::size_t
paddedCount(std::size_t count)
{
  std::size_t padded = 2 * group;
  while (padded < count)
    padded *= 2;
  return padded;
}

SortedCells
uploadPoints(Context& context,
             const Points& points,
             const Indices& chosen,
             const CellFrame& frame)
{
  const Staging staging(points, chosen, frame);
  SortedCells result;
  result.count = static_cast<cl_uint>(chosen.size());
  result.cells = upload(context, staging.cells);
  result.offsets = upload(context, staging.offsets);
  result.positions = context.device().double_precision
                         ? upload(context, staging.positions)
                         : context.buffer(1);
  return result;
}

void
sortCells(Context& context, SortedCells& cells)
{
  const std::size_t padded = paddedCount(cells.count);
  cells.entries = context.buffer(padded * sizeof(Entry));
  cl::Kernel keys = context.kernel("cellKeys");
  keys.setArg(0, cells.cells);
  keys.setArg(1, cells.count);
  keys.setArg(2, cells.entries);
  run(context, keys, padded);
  sortEntries(context, cells.entries, padded);
}

void
sortEntries(Context& context, const cl::Buffer& entries, std::size_t padded)
{
  cl::Kernel blocks = context.kernel("sortBlocks");
  cl::Kernel step = context.kernel("sortStep");
  const auto sort_blocks = [&](std::size_t first, std::size_t last) {
    blocks.setArg(0, entries);
    blocks.setArg(1, static_cast<cl_uint>(first));
    blocks.setArg(2, static_cast<cl_uint>(last));
    run(context, blocks, padded / 2);
  };
  sort_blocks(2, 2 * group);
  for (std::size_t size = 4 * group; size <= padded; size *= 2) {
    for (std::size_t stride = size / 2; stride > group; stride /= 2) {
      step.setArg(0, entries);
      step.setArg(1, static_cast<cl_uint>(size));
      step.setArg(2, static_cast<cl_uint>(stride));
      run(context, step, padded / 2);
    }
    sort_blocks(size, size);
  }
}

RunTable
neighbourRuns(Context& context, const SortedCells& queries, const SortedCells& points)
{
  RunTable table;
  table.cell_slot = context.buffer(queries.count * sizeof(cl_uint));
  const cl::Buffer slot_place = context.buffer(queries.count * sizeof(cl_uint));
  const cl::Buffer counter = context.buffer(sizeof(cl_uint));
  cl_uint slots = 0;
  context.queue().enqueueWriteBuffer(counter, CL_TRUE, 0, sizeof slots, &slots);

  cl::Kernel assign = context.kernel("assignSlots");
  assign.setArg(0, queries.entries);
  assign.setArg(1, queries.count);
  assign.setArg(2, table.cell_slot);
  assign.setArg(3, slot_place);
  assign.setArg(4, counter);
  run(context, assign, queries.count);
  context.queue().enqueueReadBuffer(counter, CL_TRUE, 0, sizeof slots, &slots);

  table.runs = context.buffer(std::size_t{slots} * 3 * rows * sizeof(cl_uint));
  cl::Kernel runs = context.kernel("neighbourRuns");
  runs.setArg(0, queries.entries);
  runs.setArg(1, slot_place);
  runs.setArg(2, slots);
  runs.setArg(3, points.entries);
  runs.setArg(4, points.count);
  runs.setArg(5, table.runs);
  run(context, runs, std::size_t{slots} * rows);
  return table;
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

void
computeTensors(Context& context,
               const std::string& definitions,
               const CellFrame& frame,
               const SortedCells& queries,
               const SortedCells& points,
               const RunTable& table,
               const std::vector<double>& radii,
               cl::Buffer& components,
               cl::Buffer& counts)
{
  const bool exact = context.device().double_precision;
  const std::size_t padded = paddedCount(points.count);
  cl::Buffer xyz[3];
  for (cl::Buffer& axis : xyz) {
    // Lanes beyond the last point are read, and weighted by 0: they must be finite.
    const std::size_t bytes = (points.count + context.lanes()) * sizeof(float);
    axis = context.buffer(bytes);
    context.queue().enqueueFillBuffer(axis, 0.0F, 0, bytes);
  }
  const cl::Buffer sorted_positions =
      context.buffer(exact ? 3 * (points.count + context.lanes()) * sizeof(double) : 1);
  cl::Kernel gather = context.kernel("gatherPoints");
  cl_uint argument = 0;
  gather.setArg(argument++, points.entries);
  gather.setArg(argument++, points.count);
  gather.setArg(argument++, points.offsets);
  gather.setArg(argument++, points.cells);
  gather.setArg(argument++, static_cast<float>(frame.cell_size));
  for (const cl::Buffer& axis : xyz)
    gather.setArg(argument++, axis);
  if (exact) {
    gather.setArg(argument++, points.positions);
    gather.setArg(argument++, sorted_positions);
  }
  run(context, gather, padded);

  const std::vector<float> float_radii(radii.begin(), radii.end());
  const cl::Buffer device_radii = upload(context, float_radii);
  const cl::Buffer exact_radii = exact ? upload(context, radii) : context.buffer(1);
  components = context.buffer(6 * queries.count * sizeof(float));
  counts = context.buffer(queries.count * sizeof(cl_uint));

  cl::Kernel kernel = context.kernel("tensors", definitions);
  argument = 0;
  kernel.setArg(argument++, queries.entries);
  kernel.setArg(argument++, queries.count);
  kernel.setArg(argument++, table.cell_slot);
  kernel.setArg(argument++, table.runs);
  kernel.setArg(argument++, queries.offsets);
  kernel.setArg(argument++, queries.cells);
  kernel.setArg(argument++, device_radii);
  kernel.setArg(argument++, static_cast<float>(frame.cell_size));
  for (const cl::Buffer& axis : xyz)
    kernel.setArg(argument++, axis);
  kernel.setArg(argument++, components);
  kernel.setArg(argument++, counts);
  if (exact) {
    kernel.setArg(argument++, sorted_positions);
    kernel.setArg(argument++, queries.positions);
    kernel.setArg(argument++, exact_radii);
  }
  run(context, kernel, queries.count);
  context.queue().finish();
}

} // namespace linelet::opencl
