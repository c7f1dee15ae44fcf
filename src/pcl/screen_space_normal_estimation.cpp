// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/screen/impl/screen_space_normal_estimation.hpp>

template class linelet::ScreenSpaceNormalEstimation<pcl::PointXYZ, pcl::Normal>;
template class linelet::ScreenSpaceNormalEstimation<pcl::PointXYZI, pcl::Normal>;
template class linelet::ScreenSpaceNormalEstimation<pcl::PointXYZRGB, pcl::Normal>;
template class linelet::ScreenSpaceNormalEstimation<pcl::PointNormal, pcl::Normal>;
template class linelet::ScreenSpaceNormalEstimation<pcl::PointXYZINormal, pcl::Normal>;
