// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <pcl/features/feature.h>
#include <pcl/memory.h>
#include <pcl/point_types.h>

#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/centroid.h>
#include <linelet/tensor/weighting.h>

namespace LINELET_PUBLIC linelet {

/** \brief Common base of the PCL classes for neighborhood shapes: shared parameters,
 * input checks, and the output.
 *
 * \tparam RecordT the output: floats, NaN if undefined, with a field `linearity`
 * \tparam Settings a struct with `weighting`, `centroid` and `threads` */
template <typename PointInT, typename RecordT, typename Settings>
class ShapeFeature : public pcl::Feature<PointInT, RecordT> {
  using Base = pcl::Feature<PointInT, RecordT>;

public:
  using PointCloudOut = typename Base::PointCloudOut;

  /** \brief w_T, fermi-dirac-1 by default. */
  void
  setWeighting(const Weighting& weighting)
  {
    settings_.weighting = weighting;
  }
  const Weighting&
  getWeighting() const
  {
    return settings_.weighting;
  }

  /** \brief The point of reference, by default the query point. */
  void
  setCentroid(Centroid centroid)
  {
    settings_.centroid = centroid;
  }
  Centroid
  getCentroid() const
  {
    return settings_.centroid;
  }

  /** \brief w_C of the weighted centroids, quadratic-inverse by default. */
  void
  setCentroidWeighting(const Weighting& weighting)
  {
    settings_.centroid_weighting = weighting;
  }
  const Weighting&
  getCentroidWeighting() const
  {
    return settings_.centroid_weighting;
  }

  /** \brief 0: what OpenMP offers. The result is the same for any number. */
  void
  setNumberOfThreads(unsigned nr_threads = 0)
  {
    settings_.threads = nr_threads;
  }
  unsigned
  getNumberOfThreads() const
  {
    return settings_.threads;
  }

  /** \brief Receives the progress of compute and may cancel it, which throws
   * linelet::Canceled. Null (default): none. It must outlive compute. */
  void
  setProgressMonitor(ProgressMonitor* monitor)
  {
    monitor_ = monitor;
  }

protected:
  using Base::fake_surface_;
  using Base::getClassName;
  using Base::indices_;
  using Base::input_;
  using Base::surface_;

  /** \brief Replaces pcl::Feature::initCompute, which would build a kd-tree that the
   * grid does not need, refuse per-point sizes, and skip the checks made here. */
  bool
  initClouds();

  /** \brief Reports why nothing is computed. \return false */
  bool
  refuse(const char* reason);

  /** \brief The points of the indices. */
  Points
  queryPoints() const;

  /** \brief Copies \a records to \a output; is_dense tells whether all are defined. */
  static void
  setOutput(PointCloudOut& output, const std::vector<RecordT>& records);

  Settings settings_;
  ProgressMonitor* monitor_ = nullptr;
};

} // namespace linelet
