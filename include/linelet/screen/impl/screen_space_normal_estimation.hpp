// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>

#include <pcl/console/print.h>

#include <linelet/screen/screen_space_normal_estimation.h>

namespace linelet {

template <typename PointInT, typename PointOutT>
ScreenSpaceNormalEstimation<PointInT, PointOutT>::ScreenSpaceNormalEstimation()
{
  feature_name_ = "ScreenSpaceNormalEstimation";
}

template <typename PointInT, typename PointOutT>
bool
ScreenSpaceNormalEstimation<PointInT, PointOutT>::refuse(const char* reason)
{
  PCL_ERROR("[linelet::%s::compute] %s\n", getClassName().c_str(), reason);
  this->deinitCompute();
  return false;
}

template <typename PointInT, typename PointOutT>
bool
ScreenSpaceNormalEstimation<PointInT, PointOutT>::initCompute()
{
  if (!pcl::PCLBase<PointInT>::initCompute())
    return refuse("there is no input cloud.");
  if (!input_->isOrganized())
    return refuse("the input cloud is not organized (its height is 1).");
  for (const pcl::index_t index : *indices_)
    if (index < 0 || static_cast<std::size_t>(index) >= input_->size())
      return refuse("an index is not one of the input cloud.");
  try {
    validate(settings_);
  }
  catch (const std::exception& error) {
    return refuse(error.what());
  }
  return true;
}

template <typename PointInT, typename PointOutT>
NormalImage
ScreenSpaceNormalEstimation<PointInT, PointOutT>::estimate(const SampleLayers& samples,
                                                           const Eigen::Vector3f& eye)
{
  return screenNormals(samples, eye, settings_);
}

template <typename PointInT, typename PointOutT>
void
ScreenSpaceNormalEstimation<PointInT, PointOutT>::computeFeature(PointCloudOut& output)
{
  SampleLayers samples;
  samples.width = static_cast<int>(input_->width);
  samples.height = static_cast<int>(input_->height);
  for (const PointInT& point : *input_) {
    samples.x.push_back(point.x);
    samples.y.push_back(point.y);
    samples.z.push_back(point.z);
  }
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  NormalImage normals;
  try {
    normals = estimate(samples, input_->sensor_origin_.template head<3>());
  }
  catch (const std::exception& error) {
    PCL_ERROR("[linelet::%s::compute] %s\n", getClassName().c_str(), error.what());
    for (auto* values : {&normals.x, &normals.y, &normals.z})
      values->assign(input_->size(), nan);
  }
  output.is_dense = true;
  for (std::size_t k = 0; k < indices_->size(); ++k) {
    const auto i = static_cast<std::size_t>((*indices_)[k]);
    output[k].normal_x = normals.x[i];
    output[k].normal_y = normals.y[i];
    output[k].normal_z = normals.z[i];
    output[k].curvature = nan;
    output.is_dense = output.is_dense && std::isfinite(normals.x[i]);
  }
}

} // namespace linelet
