// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/impl/eigen_streamline_curve_reconstruction.hpp>

template class linelet::EigenStreamlineCurveReconstruction<pcl::PointXYZ>;
template class linelet::EigenStreamlineCurveReconstruction<pcl::PointXYZI>;
template class linelet::EigenStreamlineCurveReconstruction<pcl::PointXYZRGB>;
template class linelet::EigenStreamlineCurveReconstruction<pcl::PointNormal>;
template class linelet::EigenStreamlineCurveReconstruction<pcl::PointXYZINormal>;
