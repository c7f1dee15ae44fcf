// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <exception>
#include <limits>
#include <stdexcept>
#include <utility>

#include <pcl/common/centroid.h>
#include <pcl/console/print.h>

#include <linelet/clustering/curvilinear_grid_clustering.h>

namespace linelet {

template <typename PointT>
CurvilinearGridClustering<PointT>::CurvilinearGridClustering(
    bool extract_removed_indices)
    : Base(extract_removed_indices)
{
  filter_name_ = "CurvilinearGridClustering";
}

template <typename PointT>
Clusters
CurvilinearGridClustering<PointT>::cluster(const Points& points,
                                           const std::vector<double>& field)
{
  return clusterPoints(points, settings_, field, monitor_);
}

template <typename PointT>
void
CurvilinearGridClustering<PointT>::applyFilter(PointCloud& output)
{
  output.clear();
  output.is_dense = true;
  removed_indices_->clear();
  clusters_ = {};
  // Points that are not among the indices are treated as not finite.
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Points points(input_->size(), Point(nan, nan, nan));
  try {
    for (const pcl::index_t index : *indices_) {
      if (index < 0 || static_cast<std::size_t>(index) >= input_->size())
        throw std::invalid_argument("an index is not one of the input cloud");
      const PointT& point = (*input_)[static_cast<std::size_t>(index)];
      points[static_cast<std::size_t>(index)] = Point(point.x, point.y, point.z);
    }
    clusters_ = cluster(points, field_);
  }
  catch (const Canceled&) {
    this->deinitCompute(); // as PCL's filter would after this
    throw;
  }
  catch (const std::exception& error) {
    PCL_ERROR("[linelet::%s::filter] %s\n", filter_name_.c_str(), error.what());
    clusters_ = {};
    return;
  }
  std::vector<pcl::CentroidPoint<PointT>> means(clusters_.representatives.size());
  for (const pcl::index_t index : *indices_) {
    const auto i = static_cast<std::size_t>(index);
    if (clusters_.cluster_of[i] != Clusters::none)
      means[clusters_.cluster_of[i]].add((*input_)[i]);
    else if (extract_removed_indices_)
      removed_indices_->push_back(index);
  }
  output.resize(means.size());
  for (std::size_t k = 0; k < means.size(); ++k) {
    means[k].get(output[k]);
    // CentroidPoint averages coordinates in float.
    output[k].getVector3fMap() =
        clusters_.representatives[k].center.template cast<float>();
  }
}

} // namespace linelet
