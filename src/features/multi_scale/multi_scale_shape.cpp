// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/impl/multi_scale_shape.hpp>

template class linelet::MultiScaleShapeFeature<pcl::PointXYZ>;
template class linelet::MultiScaleShapeFeature<pcl::PointXYZI>;
template class linelet::MultiScaleShapeFeature<pcl::PointXYZRGB>;
template class linelet::MultiScaleShapeFeature<pcl::PointNormal>;
template class linelet::MultiScaleShapeFeature<pcl::PointXYZINormal>;
