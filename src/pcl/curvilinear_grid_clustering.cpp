// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/clustering/impl/curvilinear_grid_clustering.hpp>

template class linelet::CurvilinearGridClustering<pcl::PointXYZ>;
template class linelet::CurvilinearGridClustering<pcl::PointXYZI>;
template class linelet::CurvilinearGridClustering<pcl::PointXYZRGB>;
template class linelet::CurvilinearGridClustering<pcl::PointNormal>;
template class linelet::CurvilinearGridClustering<pcl::PointXYZINormal>;
