// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "search_choice.h"

#include <stdexcept>
#include <string>

#ifdef LINELET_HAS_PCL
#include <linelet/features/tensor_search.h>
#include <linelet/search/pcl_search.h>
#include <linelet/search/scale_unit.h>

#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>
#endif

namespace linelet::apps {

#ifdef LINELET_HAS_PCL

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Search = pcl::search::Search<pcl::PointXYZ>;

/** \brief Leaf size of the octree: about the usual distance of neighbors, which is fast
 * for any radius. */
double
leafSize(const Points& points, const TensorSettings& settings)
{
  const double unit =
      scaleUnit(points, 1024, 1, settings.threads); // NaN for fewer than two points
  return unit > 0 ? 2 * unit : 1;
}

} // namespace

std::vector<PointDistributionTensor>
estimateWithPcl(SearchOption search,
                const Points& points,
                const Points& queries,
                const TensorSettings& settings,
                const NeighborhoodSizes& sizes,
                ProgressMonitor* monitor)
{
  auto cloud = pcl::make_shared<Cloud>();
  cloud->reserve(points.size());
  bool any_finite = false;
  for (const Point& p : points) {
    const Eigen::Vector3f f = p.cast<float>();
    cloud->emplace_back(f.x(), f.y(), f.z());
    cloud->is_dense = cloud->is_dense && f.allFinite();
    any_finite = any_finite || f.allFinite();
  }
  if (!any_finite) // PCL's searches would crash
    return std::vector<PointDistributionTensor>(queries.size(), unknownTensor(0));
  Search::Ptr tree;
  if (search == SearchOption::Flann)
    tree = pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false);
  else
    tree = pcl::make_shared<pcl::search::Octree<pcl::PointXYZ>>(
        leafSize(points, settings));
  tree->setInputCloud(cloud);
  return estimateTensors(PclSearch<pcl::PointXYZ>(*tree, points),
                         points,
                         queries,
                         settings,
                         sizes,
                         monitor);
}

#else

std::vector<PointDistributionTensor>
estimateWithPcl(SearchOption search,
                const Points&,
                const Points&,
                const TensorSettings&,
                const NeighborhoodSizes&,
                ProgressMonitor*)
{
  throw std::runtime_error("--search " + std::string(nameOf(search)) +
                           " is one of PCL's, which this linelet was built without; "
                           "use --search builtin or grid");
}

#endif

} // namespace linelet::apps
