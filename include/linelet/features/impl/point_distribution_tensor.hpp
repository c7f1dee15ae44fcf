// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <pcl/console/print.h>

#include <linelet/features/point_distribution_tensor.h>
#include <linelet/search/pcl_search.h>

namespace linelet {

template <typename PointInT>
PointDistributionTensorEstimation<PointInT>::PointDistributionTensorEstimation()
{
  feature_name_ = "PointDistributionTensorEstimation";
}

template <typename PointInT>
bool
PointDistributionTensorEstimation<PointInT>::refuse(const char* reason)
{
  PCL_ERROR("[pcl::%s::compute] %s\n", getClassName().c_str(), reason);
  this->deinitCompute();
  return false;
}

// Base::initCompute would build a kd-tree that a grid makes superfluous, and refuse
// sizes point by point. What else it does is done here, with the checks that it leaves
// out.
template <typename PointInT>
bool
PointDistributionTensorEstimation<PointInT>::initCompute()
{
  if (!pcl::PCLBase<PointInT>::initCompute())
    return refuse("there is no input cloud.");
  if (input_->empty())
    return refuse("the input cloud is empty.");
  if (!surface_) {
    fake_surface_ = true;
    surface_ = input_;
  }
  for (const pcl::index_t index : *indices_)
    if (index < 0 || static_cast<std::size_t>(index) >= input_->size())
      return refuse("an index is not one of the input cloud.");
  const bool any_finite =
      std::any_of(surface_->begin(), surface_->end(), [](const PointInT& point) {
        return std::isfinite(point.x) && std::isfinite(point.y) &&
               std::isfinite(point.z);
      });
  if (!any_finite)
    return refuse("the search surface has no finite point.");
  if (k_ < 0)
    return refuse("k is negative.");
  try {
    TensorSettings settings = settings_;
    settings.radius = search_radius_;
    settings.k = static_cast<unsigned>(k_);
    validate(settings, sizes_, input_->size());
  }
  catch (const std::invalid_argument& error) {
    return refuse(error.what());
  }
  search_parameter_ = k_ > 0 ? k_ : search_radius_;
  if (tree_ && tree_->getInputCloud() != surface_)
    tree_->setInputCloud(surface_);
  return true;
}

template <typename PointInT>
NeighbourhoodSizes
PointDistributionTensorEstimation<PointInT>::querySizes() const
{
  NeighbourhoodSizes sizes;
  for (const pcl::index_t index : *indices_) {
    const auto i = static_cast<std::size_t>(index);
    if (!sizes_.radii.empty())
      sizes.radii.push_back(sizes_.radii[i]);
    if (!sizes_.counts.empty())
      sizes.counts.push_back(sizes_.counts[i]);
  }
  return sizes;
}

template <typename PointInT>
std::vector<PointDistributionTensor>
PointDistributionTensorEstimation<PointInT>::estimate(const Points& surface,
                                                      const Points& queries,
                                                      const TensorSettings& settings,
                                                      const NeighbourhoodSizes& sizes)
{
  if (tree_ && settings.engine == Engine::Auto)
    return estimateTensors(
        PclSearch<PointInT>(*tree_, surface), surface, queries, settings, sizes);
  return estimateTensors(surface, queries, settings, sizes);
}

template <typename PointInT>
void
PointDistributionTensorEstimation<PointInT>::computeFeature(PointCloudOut& output)
{
  TensorSettings settings = settings_;
  settings.radius = search_radius_;
  settings.k = static_cast<unsigned>(k_);
  const Points surface = pointsOf(*surface_);
  Points queries;
  queries.reserve(indices_->size());
  for (const pcl::index_t index : *indices_) {
    const PointInT& point = (*input_)[static_cast<std::size_t>(index)];
    queries.emplace_back(point.x, point.y, point.z);
  }

  std::vector<PointDistributionTensor> records;
  try {
    records = estimate(surface, queries, settings, querySizes());
  }
  catch (const std::exception& error) {
    PCL_ERROR("[pcl::%s::compute] %s\n", getClassName().c_str(), error.what());
    records.assign(queries.size(), unknownTensor(0));
  }
  output.is_dense = true;
  for (std::size_t i = 0; i < records.size(); ++i) {
    output[i] = records[i];
    if (std::isnan(records[i].linearity))
      output.is_dense = false;
  }
}

} // namespace linelet
