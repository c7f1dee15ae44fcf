// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <utility>

#include <linelet/features/impl/point_distribution_tensor.hpp>
#include <linelet/opencl/point_distribution_tensor_ocl.h>

namespace linelet {

template <typename PointInT>
PointDistributionTensorEstimationOCL<PointInT>::PointDistributionTensorEstimationOCL(
    std::string device)
    : device_(std::move(device))
{
  feature_name_ = "PointDistributionTensorEstimationOCL";
}

template <typename PointInT>
opencl::TensorEngine&
PointDistributionTensorEstimationOCL<PointInT>::engine()
{
  if (!engine_)
    engine_ = std::make_shared<opencl::TensorEngine>(device_);
  return *engine_;
}

template <typename PointInT>
std::vector<PointDistributionTensor>
PointDistributionTensorEstimationOCL<PointInT>::estimate(const Points& surface,
                                                         const Points& queries,
                                                         const TensorSettings& settings,
                                                         const NeighborhoodSizes& sizes)
{
  return engine().estimate(surface, queries, settings, sizes);
}

} // namespace linelet
