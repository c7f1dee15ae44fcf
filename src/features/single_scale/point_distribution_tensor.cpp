// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/impl/point_distribution_tensor.hpp>

template class linelet::PointDistributionTensorEstimation<pcl::PointXYZ>;
template class linelet::PointDistributionTensorEstimation<pcl::PointXYZI>;
template class linelet::PointDistributionTensorEstimation<pcl::PointXYZRGB>;
template class linelet::PointDistributionTensorEstimation<pcl::PointNormal>;
template class linelet::PointDistributionTensorEstimation<pcl::PointXYZINormal>;
