// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <pcl/point_cloud.h>
#include <pcl/search/search.h>

#include <linelet/search/nearest_candidates.h>
#include <linelet/search/neighbor_search.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The points of a PCL cloud in double, in order, NaN included. */
template <typename PointT>
Points
pointsOf(const pcl::PointCloud<PointT>& cloud)
{
  Points points;
  points.reserve(cloud.size());
  for (const PointT& point : cloud)
    points.emplace_back(point.x, point.y, point.z);
  return points;
}

/** \brief Any `pcl::search::Search` as a NeighborSearch.
 *
 * PCL's searches compute distances in float, each in its own way, so they only supply
 * candidates within a slightly larger radius; double precision decides. */
template <typename PointT>
class PclSearch : public NeighborSearch {
public:
  /** \param[in] search over a cloud with at least one finite point; kept by reference,
   * its const functions are called from several threads
   * \param[in] points the points of that cloud, see \ref pointsOf; kept by reference
   * \throws std::invalid_argument if no point is finite: PCL's radius search would then
   * crash */
  PclSearch(const pcl::search::Search<PointT>& search, const Points& points)
      : search_(search), points_(points)
  {
    for (const Point& point : points)
      if (point.allFinite()) {
        largest_ = std::max(largest_, point.cwiseAbs().maxCoeff());
        any_ = true;
      }
    if (!any_)
      throw std::invalid_argument("the search surface has no finite point");
  }

  void
  within(const Point& query, double radius, Indices& found) const override
  {
    found.clear();
    if (!(radius >= 0) || !query.allFinite())
      return;
    const double squared_radius = radius * radius;
    forEachCandidate(query, radius, [&](Index index, double squared) {
      if (squared <= squared_radius)
        found.push_back(index);
    });
    std::sort(found.begin(), found.end());
  }

  double
  nearest(const Point& query, std::size_t count, Indices& found) const override
  {
    found.clear();
    if (count == 0 || !query.allFinite())
      return 0;
    thread_local pcl::Indices neighbors;
    thread_local std::vector<float> distances;
    const std::size_t most = std::min(count, points_.size());
    search_.nearestKSearch(
        pclPoint(query), static_cast<int>(most), neighbors, distances);
    double squared_radius = 0;
    for (const pcl::index_t neighbor : neighbors)
      squared_radius = std::max(squared_radius, squaredDistance(query, neighbor));
    thread_local std::vector<std::pair<double, Index>> candidates;
    candidates.clear();
    forEachCandidate(
        query, std::sqrt(squared_radius), [&](Index index, double squared) {
          candidates.emplace_back(squared, index);
        });
    return keepNearest(candidates, count, found);
  }

private:
  static PointT
  pclPoint(const Point& query)
  {
    PointT point;
    point.x = static_cast<float>(query.x());
    point.y = static_cast<float>(query.y());
    point.z = static_cast<float>(query.z());
    return point;
  }

  double
  squaredDistance(const Point& query, pcl::index_t neighbor) const
  {
    return (points_[static_cast<std::size_t>(neighbor)] - query).squaredNorm();
  }

  template <class Visit>
  void
  forEachCandidate(const Point& query, double radius, Visit&& visit) const
  {
    // relative covers sums of squares in float and projection into an image; absolute
    // covers rounding of coordinates to float, also in the boxes of an octree.
    constexpr double relative = 1e-4;
    constexpr double absolute = 4 * std::numeric_limits<float>::epsilon();
    const double coordinate = std::max(largest_, query.cwiseAbs().maxCoeff());
    const double reach = radius * (1 + relative) + coordinate * absolute;
    thread_local pcl::Indices neighbors;
    thread_local std::vector<float> distances;
    search_.radiusSearch(pclPoint(query), reach, neighbors, distances);
    for (const pcl::index_t neighbor : neighbors)
      visit(static_cast<Index>(neighbor), squaredDistance(query, neighbor));
  }

  const pcl::search::Search<PointT>& search_;
  const Points& points_;
  double largest_ = 0; // magnitude of a coordinate
  bool any_ = false;
};

} // namespace linelet
