// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tensor_stages.h"

#include <sstream>

#include <linelet/features/point_types.h>

#include "launch.h"

namespace linelet::opencl {

namespace {

static_assert(sizeof(PointDistributionTensor) == 19 * sizeof(float),
              "shapes.cl writes 18 floats and a count");

/** \brief The points of a slab in sorted order, see gatherPoints. */
struct SortedPlaces {
  SortedPlaces(Context& context, const Slab& slab);

  cl::Buffer x, y, z;
};

SortedPlaces::SortedPlaces(Context& context, const Slab& slab)
{
  // Lanes beyond the last point are read, and weighted by 0: they must be finite.
  const std::size_t bytes = (slab.points.count + context.lanes()) * sizeof(float);
  for (cl::Buffer* axis : {&x, &y, &z}) {
    *axis = context.buffer(bytes);
    context.queue().enqueueFillBuffer(*axis, 0.0F, 0, bytes);
  }
  cl::Kernel gather = context.kernel("gatherPoints");
  setArguments(gather,
               slab.point_keys,
               slab.points.count,
               slab.layout,
               slab.points.offsets,
               slab.points.cells,
               slab.frame.cellSize(),
               x,
               y,
               z);
  run(context, gather, slab.points.count);
}

/** \brief The names that context.cpp defines for enumerators. */
const char*
macroOf(Kernel kernel)
{
  switch (kernel) {
#define LINELET_KERNEL(kernel, name, support, weight)                                  \
  case Kernel::kernel:                                                                 \
    return "KERNEL_" #kernel;
    LINELET_KERNELS(LINELET_KERNEL)
#undef LINELET_KERNEL
  }
  return "";
}

const char*
macroOf(Centroid centroid)
{
  switch (centroid) {
  case Centroid::QueryPoint:
    return "CENTROID_QueryPoint";
  case Centroid::Mean:
    return "CENTROID_Mean";
  case Centroid::WeightedMean:
    return "CENTROID_WeightedMean";
  case Centroid::Median:
    return "CENTROID_Median";
  case Centroid::WeightedMedian:
    break;
  }
  return ""; // refused before
}

} // namespace

std::string
tensorDefinitions(Centroid centroid,
                  const Weighting& tensor_weight,
                  const Weighting& centroid_weight)
{
  std::ostringstream text;
  text.precision(9);
  text << std::showpoint << "-DCENTROID=" << macroOf(centroid);
  const auto define =
      [&](const char* name, const char letter, const Weighting& weight) {
        text << " -D" << name << '=' << macroOf(weight.kernel()) << " -D" << letter
             << "_FIRST=" << weight.parameters()[0] << "f -D" << letter
             << "_SECOND=" << weight.parameters()[1] << 'f';
      };
  define("TENSOR_WEIGHT", 'W', tensor_weight);
  define("CENTROID_WEIGHT", 'C', centroid_weight);
  return text.str();
}

DeviceTensors
computeTensors(Context& context,
               const std::string& definitions,
               const Slab& slab,
               const std::vector<double>& radii)
{
  const SortedPlaces places(context, slab);
  const cl_uint count = slab.queries.count, lanes = context.lanes();
  DeviceTensors result;
  result.radii = upload(context, std::vector<float>(radii.begin(), radii.end()));
  result.stride = (count + lanes - 1) / lanes * lanes;
  result.components = context.buffer(6 * result.stride * sizeof(float));
  result.counts = context.buffer(count * sizeof(cl_uint));
  cl::Kernel kernel = context.kernel("tensors", definitions);
  setArguments(kernel,
               slab.query_keys,
               count,
               slab.layout,
               slab.table.query_slot,
               slab.table.places,
               slab.queries.offsets,
               slab.queries.cells,
               result.radii,
               slab.frame.cellSize(),
               places.x,
               places.y,
               places.z,
               result.stride,
               result.components,
               result.counts);
  cl::Buffer exact_radii;
  if (context.device().double_precision) {
    exact_radii = upload(context, radii);
    setArgumentsFrom(15,
                     kernel,
                     slab.point_keys,
                     slab.points.positions,
                     slab.queries.positions,
                     exact_radii);
  }
  run(context, kernel, count);
  context.queue().finish();
  return result;
}

cl::Buffer
computeShapes(Context& context, const DeviceTensors& tensors, const Slab& slab)
{
  const cl_uint count = slab.queries.count, lanes = context.lanes();
  cl::Buffer records = context.buffer(count * sizeof(PointDistributionTensor));
  cl::Kernel kernel = context.kernel("shapes");
  setArguments(kernel,
               slab.query_keys,
               count,
               slab.layout.index_bits,
               tensors.radii,
               tensors.stride,
               tensors.components,
               tensors.counts,
               records);
  run(context, kernel, (count + lanes - 1) / lanes);
  return records;
}

std::vector<double>
nearestSquares(Context& context, const Slab& slab, const std::vector<cl_uint>& wanted)
{
  const SortedPlaces places(context, slab);
  const cl_uint count = slab.queries.count;
  const cl::Buffer device_wanted = upload(context, wanted);
  const cl::Buffer squares = context.buffer(count * sizeof(double));
  cl::Kernel kernel = context.kernel(
      "nearestSquares",
      "-DNEAREST " +
          tensorDefinitions(Centroid::QueryPoint, Kernel::Const, Kernel::Const));
  setArguments(kernel,
               slab.query_keys,
               count,
               slab.layout,
               slab.table.query_slot,
               slab.table.places,
               slab.queries.offsets,
               slab.queries.cells,
               slab.frame.cellSize(),
               places.x,
               places.y,
               places.z,
               slab.point_keys,
               slab.points.positions,
               slab.queries.positions,
               device_wanted,
               static_cast<cl_float>(slab.frame.cell_size * (1 - 1e-6)), // for rounding
               squares);
  run(context, kernel, count);
  std::vector<double> result(count);
  context.queue().enqueueReadBuffer(
      squares, CL_TRUE, 0, count * sizeof(double), result.data());
  return result;
}

} // namespace linelet::opencl
