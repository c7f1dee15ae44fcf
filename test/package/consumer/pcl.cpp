// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <linelet/curves/eigen_streamline_curve_reconstruction.h>

int
main()
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (float t = 0; t < 6.28F; t += 0.02F)
    cloud->push_back(pcl::PointXYZ(5 * std::cos(t), 5 * std::sin(t), 0));
  linelet::EigenStreamlineCurveReconstruction<pcl::PointXYZ> reconstruction;
  reconstruction.setInputCloud(cloud);
  return reconstruction.reconstruct().curves.size() == 1 ? 0 : 1;
}
