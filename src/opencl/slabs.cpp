// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slabs.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace linelet::opencl {

namespace {

/** \brief Points or queries of a slab: the device counts places of its tables in 32
 * bits. */
constexpr std::size_t most_at_once = std::size_t{1} << 25;

/** \brief Bytes on the device for points and queries, without the table. */
std::size_t
bytesNeeded(std::size_t points, std::size_t queries)
{
  // Cell, offset, position, key, sorted position.
  const std::size_t per_point = 16 + 12 + 24 + 8 + 12;
  // Cell, offset, position, key, slot, radii, tensor, count, record.
  const std::size_t per_query = 16 + 12 + 24 + 8 + 8 + 12 + 24 + 4 + 76;
  return per_point * points + per_query * queries + 16 * sort_block;
}

bool
isOutOfMemory(cl_int code)
{
  return code == CL_MEM_OBJECT_ALLOCATION_FAILURE || code == CL_OUT_OF_RESOURCES ||
         code == CL_OUT_OF_HOST_MEMORY || code == CL_INVALID_BUFFER_SIZE;
}

} // namespace

Slabs::Slabs(Context& context,
             const Points& surface,
             const Points& queries,
             std::size_t memory_limit,
             int threads,
             StageTimes& times,
             ProgressMonitor* monitor)
    : context_(context),
      surface_(surface),
      queries_(queries),
      memory_limit_(memory_limit),
      threads_(threads),
      times_(times),
      monitor_(monitor)
{
}

void
Slabs::forEach(const Indices& points,
               Indices queries,
               const std::vector<double>& radii,
               const Work& work)
{
  if (monitor_ != nullptr && monitor_->canceled())
    throw Canceled();
  if (points.empty() || queries.empty())
    return;
  double largest = 0;
  for (const Index i : queries)
    largest = std::max(largest, radii[i]);
  const CellFrame frame(surface_, points, largest);
  const std::size_t most = std::max(points.size(), queries.size());
  const bool small = bytesNeeded(points.size(), queries.size()) <= memory_limit_ &&
                     most <= most_at_once;
  if (queries.size() == 1 || (small && frame.fits(most))) {
    try {
      work(upload(points, queries, frame), queries);
      ++count_;
      return;
    }
    catch (const cl::Error& error) {
      if (queries.size() == 1 || !isOutOfMemory(error.err()))
        throw;
    }
  }
  halve(points, queries, largest, radii, work);
}

/** Cuts the queries at their median along the longest axis; each half takes the points
 * within the radius around it. */
void
Slabs::halve(const Indices& points,
             Indices& queries,
             double largest,
             const std::vector<double>& radii,
             const Work& work)
{
  const Eigen::AlignedBox3d box = boxOf(queries);
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto middle =
      queries.begin() + static_cast<Indices::difference_type>(queries.size() / 2);
  std::nth_element(queries.begin(), middle, queries.end(), [&](Index a, Index b) {
    return queries_[a][axis] < queries_[b][axis];
  });
  Indices halves[2] = {{queries.begin(), middle}, {middle, queries.end()}};
  queries = {};
  const Point reach = Point::Constant(largest * (1 + 1e-6));
  for (Indices& half : halves) {
    const Eigen::AlignedBox3d inner = boxOf(half);
    const Eigen::AlignedBox3d outer(inner.min() - reach, inner.max() + reach);
    Indices near;
    std::copy_if(points.begin(), points.end(), std::back_inserter(near), [&](Index i) {
      return outer.contains(surface_[i]);
    });
    forEach(near, std::move(half), radii, work);
  }
}

Eigen::AlignedBox3d
Slabs::boxOf(const Indices& queries) const
{
  Eigen::AlignedBox3d box;
  for (const Index i : queries)
    box.extend(queries_[i]);
  return box;
}

Slab
Slabs::upload(const Indices& points, const Indices& queries, const CellFrame& frame)
{
  Lap lap(context_.queue());
  // The usual case: every point is a query.
  const bool same = &surface_ == &queries_ && points == queries;
  Slab slab{
      frame, frame.layout(std::max(points.size(), queries.size())), {}, {}, {}, {}, {}};
  slab.points = uploadPoints(context_, surface_, points, frame, threads_);
  slab.queries =
      same ? slab.points : uploadPoints(context_, queries_, queries, frame, threads_);
  lap.add(times_.upload);
  slab.point_keys = sortedKeys(context_, slab.points, frame, slab.layout);
  slab.query_keys =
      same ? slab.point_keys : sortedKeys(context_, slab.queries, frame, slab.layout);
  slab.table = assignSlots(context_, slab.query_keys, queries.size(), slab.layout);
  if (queries.size() > 1 &&
      bytesNeeded(points.size(), queries.size()) + slab.table.bytes() > memory_limit_)
    throw cl::Error(CL_MEM_OBJECT_ALLOCATION_FAILURE, "the table of cells");
  fillTable(context_,
            slab.table,
            slab.query_keys,
            slab.point_keys,
            points.size(),
            slab.layout);
  lap.add(times_.grid);
  return slab;
}

} // namespace linelet::opencl
