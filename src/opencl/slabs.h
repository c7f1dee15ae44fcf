// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <functional>
#include <vector>

#include <Eigen/Geometry>

#include <linelet/opencl/stage_times.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>

#include "stages.h"

namespace linelet::opencl {

/** \brief Adds the time since its construction, or the last call, to a stage. */
class Lap {
public:
  explicit Lap(const cl::CommandQueue& queue) : queue_(queue) {}

  void
  add(double& stage)
  {
    queue_.finish();
    const auto now = Clock::now();
    stage += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

private:
  using Clock = std::chrono::steady_clock;
  const cl::CommandQueue& queue_;
  Clock::time_point last_ = Clock::now();
};

/** \brief Brings queries and the points around them onto the device, in as many slabs
 * as its memory and the cell keys require. */
class Slabs {
public:
  /** \brief Processes a slab with the indices of its queries; must return only when the
   * device has finished. */
  using Work = std::function<void(const Slab&, const Indices&)>;

  /** \param[in] memory_limit bytes on the device
   * \param[in] threads of the host
   * \param[out] times of upload and grid are added to */
  Slabs(Context& context,
        const Points& surface,
        const Points& queries,
        std::size_t memory_limit,
        int threads,
        StageTimes& times,
        ProgressMonitor* monitor);

  /** \brief Calls \a work for the slabs of some queries and the points around them.
   * \param[in] points finite ones of the surface
   * \param[in] queries finite ones, each with a neighborhood
   * \param[in] radii how far neighbors lie, by query
   * \throws Canceled between slabs
   * \throws cl::Error */
  void
  forEach(const Indices& points,
          Indices queries,
          const std::vector<double>& radii,
          const Work& work);

  std::size_t
  count() const
  {
    return count_;
  }

private:
  void
  halve(const Indices& points,
        Indices& queries,
        double largest,
        const std::vector<double>& radii,
        const Work& work);

  Slab
  upload(const Indices& points, const Indices& queries, const CellFrame& frame);

  Eigen::AlignedBox3d
  boxOf(const Indices& queries) const;

  Context& context_;
  const Points& surface_;
  const Points& queries_;
  std::size_t memory_limit_;
  int threads_;
  StageTimes& times_;
  ProgressMonitor* monitor_;
  std::size_t count_ = 0;
};

} // namespace linelet::opencl
