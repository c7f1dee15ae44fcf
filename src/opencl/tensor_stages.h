// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/tensor/centroid.h>
#include <linelet/tensor/weighting.h>

#include "stages.h"

namespace linelet::opencl {

/** \brief Definitions that specialize the tensor kernel for a centroid and weightings.
 */
std::string
tensorDefinitions(Centroid centroid,
                  const Weighting& tensor_weight,
                  const Weighting& centroid_weight);

/** \brief Tensors on the device, by place of the query in sorted order. */
struct DeviceTensors {
  cl::Buffer radii;      // one per query, by index
  cl_uint stride = 0;    // between components
  cl::Buffer components; // xx xy xz yy yz zz
  cl::Buffer counts;     // neighbors
};

/** \brief Runs the tensor kernel, specialized by \a definitions.
 * \param[in] radii one per query */
DeviceTensors
computeTensors(Context& context,
               const std::string& definitions,
               const Slab& slab,
               const std::vector<double>& radii);

/** \brief Runs the eigen-analysis.
 * \return records (\ref PointDistributionTensor), by index of the query; their number
 * of neighbors is \ref undecided where that of the tensors is */
cl::Buffer
computeShapes(Context& context, const DeviceTensors& tensors, const Slab& slab);

/** \brief Stands for a number of neighbors that only double could decide, on a device
 * without it. */
constexpr cl_uint undecided = 0xffffffff;

/** \brief Squared distance of the n-th nearest point of every query, in double, on a
 * device that supports it.
 * \param[in] wanted n, at least 1, for every query
 * \return NaN if there are fewer within a cell's width, or too many at about that
 * distance */
std::vector<double>
nearestSquares(Context& context, const Slab& slab, const std::vector<cl_uint>& wanted);

} // namespace linelet::opencl
