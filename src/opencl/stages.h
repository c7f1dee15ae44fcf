// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/points.h>
#include <linelet/tensor/centroid.h>
#include <linelet/tensor/weighting.h>

#include "context.h"

namespace linelet::opencl {

/** \brief What the kernels call an entry: a point or query under the key of its cell.
 */
struct Entry {
  cl_ulong key;
  cl_uint index;
  cl_uint unused;
};

/** \brief The cells of a cloud: half as wide as the largest radius, counted from a
 * corner that lies a radius below every point. */
struct CellFrame {
  Point corner = Point::Zero();
  double cell_size = 1;

  /** \brief Cells for radii up to \a radius, wider where the extent would need more
   * than 2^20 of them along an axis. */
  CellFrame(const Points& points, const Indices& chosen, double radius);
};

/** \brief Points on the device: cell, place in the cell (float) and, where the device
 * computes in double, the position itself, plus the entries sorted by cell. */
struct SortedCells {
  cl_uint count = 0;
  cl::Buffer cells;     // int4
  cl::Buffer offsets;   // 3 floats
  cl::Buffer positions; // 3 doubles, a single byte without double precision
  cl::Buffer entries;   // Entry, sorted, padded to a power of two
};

/** \brief Entries needed on the device for \a count points: a power of two. */
std::size_t
paddedCount(std::size_t count);

/** \brief Uploads the chosen points. The entries are not made yet. */
SortedCells
uploadPoints(Context& context,
             const Points& points,
             const Indices& chosen,
             const CellFrame& frame);

/** \brief Makes the entries of \a cells and sorts them by key, then index. */
void
sortCells(Context& context, SortedCells& cells);

/** \brief Sorts \a padded entries (see \ref paddedCount) on the device. */
void
sortEntries(Context& context, const cl::Buffer& entries, std::size_t padded);

/** \brief For each cell that holds a query, the runs of points around it. */
struct RunTable {
  cl::Buffer cell_slot; // by place of a cell's first query: its row in runs
  cl::Buffer runs;      // 25 x (begin, next chunk, end) a slot
};

RunTable
neighbourRuns(Context& context, const SortedCells& queries, const SortedCells& points);

/** \brief Definitions that specialise the tensor kernel for a centroid and weightings.
 */
std::string
tensorDefinitions(Centroid centroid,
                  const Weighting& tensor_weight,
                  const Weighting& centroid_weight);

/** \brief Runs the tensor kernel.
 * \param[in] radii one a query
 * \param[out] components six floats a query: xx xy xz yy yz zz \param[out] counts
 * neighbours of each query */
void
computeTensors(Context& context,
               const std::string& definitions,
               const CellFrame& frame,
               const SortedCells& queries,
               const SortedCells& points,
               const RunTable& table,
               const std::vector<double>& radii,
               cl::Buffer& components,
               cl::Buffer& counts);

} // namespace linelet::opencl
