// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/opencl/impl/point_distribution_tensor_ocl.hpp>

template class linelet::PointDistributionTensorEstimationOCL<pcl::PointXYZ>;
template class linelet::PointDistributionTensorEstimationOCL<pcl::PointXYZI>;
template class linelet::PointDistributionTensorEstimationOCL<pcl::PointXYZRGB>;
template class linelet::PointDistributionTensorEstimationOCL<pcl::PointNormal>;
template class linelet::PointDistributionTensorEstimationOCL<pcl::PointXYZINormal>;
