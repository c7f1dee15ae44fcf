// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <stdexcept>

#include <linelet/features/impl/shape_feature.hpp>
#include <linelet/features/point_distribution_tensor.h>
#include <linelet/search/pcl_search.h>

namespace linelet {

template <typename PointInT>
PointDistributionTensorEstimation<PointInT>::PointDistributionTensorEstimation()
{
  feature_name_ = "PointDistributionTensorEstimation";
}

template <typename PointInT>
TensorSettings
PointDistributionTensorEstimation<PointInT>::fullSettings() const
{
  TensorSettings settings = settings_;
  settings.radius = search_radius_;
  settings.k = static_cast<unsigned>(k_);
  return settings;
}

template <typename PointInT>
bool
PointDistributionTensorEstimation<PointInT>::initCompute()
{
  if (!this->initClouds())
    return false;
  if (k_ < 0)
    return this->refuse("k is negative.");
  try {
    validate(fullSettings(), sizes_, input_->size());
  }
  catch (const std::invalid_argument& error) {
    return this->refuse(error.what());
  }
  search_parameter_ = k_ > 0 ? k_ : search_radius_;
  if (tree_ && tree_->getInputCloud() != surface_)
    tree_->setInputCloud(surface_);
  return true;
}

template <typename PointInT>
NeighborhoodSizes
PointDistributionTensorEstimation<PointInT>::querySizes() const
{
  NeighborhoodSizes sizes;
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
                                                      const NeighborhoodSizes& sizes)
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
  const Points queries = this->queryPoints();
  std::vector<PointDistributionTensor> records;
  try {
    records = estimate(pointsOf(*surface_), queries, fullSettings(), querySizes());
  }
  catch (const std::exception& error) {
    PCL_ERROR("[pcl::%s::compute] %s\n", getClassName().c_str(), error.what());
    records.assign(queries.size(), unknownTensor(0));
  }
  this->setOutput(output, records);
}

} // namespace linelet
