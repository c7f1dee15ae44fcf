// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include <pcl/console/print.h>
#include <pcl/conversions.h>

#include <linelet/curves/eigen_streamline_curve_reconstruction.h>
#include <linelet/search/pcl_search.h>
#include <linelet/search/subset_search.h>

namespace linelet {

template <typename PointInT>
bool
EigenStreamlineCurveReconstruction<PointInT>::refuse(const char* reason) const
{
  PCL_ERROR("[linelet::%s::reconstruct] %s\n", getClassName().c_str(), reason);
  return false;
}

// Base::reconstruct would use the input before checking that there is one.
template <typename PointInT>
bool
EigenStreamlineCurveReconstruction<PointInT>::chosenPoints(Points& points,
                                                           Indices& indices)
{
  if (!input_)
    return refuse("there is no input cloud.");
  if (!initCompute())
    return refuse("the input cloud cannot be used.");
  for (const pcl::index_t index : *indices_) {
    if (index < 0 || static_cast<std::size_t>(index) >= input_->size()) {
      deinitCompute();
      return refuse("an index is not one of the input cloud.");
    }
    const PointInT& point = (*input_)[static_cast<std::size_t>(index)];
    points.emplace_back(point.x, point.y, point.z);
    indices.push_back(static_cast<Index>(index));
  }
  deinitCompute();
  return true;
}

template <typename PointInT>
CurveNetwork
EigenStreamlineCurveReconstruction<PointInT>::reconstruct(const Points& points,
                                                          const Indices& indices)
{
  const auto finite = [](const Point& point) { return point.allFinite(); };
  if (!tree_ || std::none_of(points.begin(), points.end(), finite))
    return reconstructCurves(points, settings_, monitor_);
  if (tree_->getInputCloud() != input_)
    tree_->setInputCloud(input_);
  const Points all = pointsOf(*input_);
  const PclSearch<PointInT> search(*tree_, all);
  const bool whole =
      indices.size() == all.size() && std::is_sorted(indices.begin(), indices.end()) &&
      std::adjacent_find(indices.begin(), indices.end()) == indices.end();
  if (whole)
    return reconstructCurves(search, points, settings_, monitor_);
  return reconstructCurves(
      SubsetSearch(search, all, indices), points, settings_, monitor_);
}

template <typename PointInT>
CurveNetwork
EigenStreamlineCurveReconstruction<PointInT>::reconstruct()
{
  Points points;
  Indices indices;
  if (!chosenPoints(points, indices))
    return {};
  try {
    return reconstruct(points, indices);
  }
  catch (const std::invalid_argument& error) {
    refuse(error.what());
    return {};
  }
}

template <typename PointInT>
void
EigenStreamlineCurveReconstruction<PointInT>::reconstruct(pcl::PolygonMesh& output)
{
  output = pcl::PolygonMesh();
  if (input_)
    output.header = input_->header;
  performReconstruction(output);
}

template <typename PointInT>
void
EigenStreamlineCurveReconstruction<PointInT>::reconstruct(
    pcl::PointCloud<PointInT>& points, std::vector<pcl::Vertices>& polygons)
{
  points = pcl::PointCloud<PointInT>();
  if (input_)
    points.header = input_->header;
  performReconstruction(points, polygons);
}

template <typename PointInT>
void
EigenStreamlineCurveReconstruction<PointInT>::performReconstruction(
    pcl::PolygonMesh& output)
{
  pcl::PointCloud<PointInT> points;
  performReconstruction(points, output.polygons);
  points.header = output.header;
  pcl::toPCLPointCloud2(points, output.cloud);
}

template <typename PointInT>
void
EigenStreamlineCurveReconstruction<PointInT>::performReconstruction(
    pcl::PointCloud<PointInT>& points, std::vector<pcl::Vertices>& polygons)
{
  polygons.clear();
  for (const Curve& curve : reconstruct().curves) {
    pcl::Vertices polygon;
    for (const Point& vertex : curve.points) {
      PointInT point;
      point.x = static_cast<float>(vertex.x());
      point.y = static_cast<float>(vertex.y());
      point.z = static_cast<float>(vertex.z());
      polygon.vertices.push_back(static_cast<pcl::index_t>(points.size()));
      points.push_back(point);
    }
    if (curve.closed && !polygon.vertices.empty())
      polygon.vertices.push_back(polygon.vertices.front());
    polygons.push_back(std::move(polygon));
  }
}

} // namespace linelet
