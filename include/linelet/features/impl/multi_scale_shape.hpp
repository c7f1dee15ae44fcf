// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <pcl/console/print.h>

#include <linelet/features/multi_scale_shape.h>
#include <linelet/search/pcl_search.h>

namespace linelet {

template <typename PointInT>
MultiScaleShapeFeature<PointInT>::MultiScaleShapeFeature()
{
  feature_name_ = "MultiScaleShapeFeature";
}

template <typename PointInT>
bool
MultiScaleShapeFeature<PointInT>::refuse(const char* reason)
{
  PCL_ERROR("[pcl::%s::compute] %s\n", getClassName().c_str(), reason);
  surface_points_.clear();
  this->deinitCompute();
  return false;
}

template <typename PointInT>
void
MultiScaleShapeFeature<PointInT>::forget()
{
  graphs_.clear();
  radii_.clear();
  scale_unit_ = noise_rate_ = noise_width_ = std::numeric_limits<double>::quiet_NaN();
}

// Base::initCompute would build a kd-tree that nobody asks, and refuse a feature
// without radius.
template <typename PointInT>
bool
MultiScaleShapeFeature<PointInT>::initCompute()
{
  forget();
  if (!pcl::PCLBase<PointInT>::initCompute())
    return refuse("there is no input cloud.");
  if (input_->empty())
    return refuse("the input cloud is empty.");
  if (!surface_) {
    fake_surface_ = true;
    surface_ = input_;
  }
  for (const pcl::index_t index : *indices_)
    if (index < 0 || static_cast<std::size_t>(index) >= input_->size())
      return refuse("an index is not one of the input cloud.");
  if (k_ != 0)
    return refuse("a number of neighbours is set; the scales are radii.");
  if (search_radius_ != 0 && settings_.max_radius != 0)
    return refuse("both a search radius and a largest radius are set.");
  surface_points_ = pointsOf(*surface_);
  if (std::none_of(surface_points_.begin(),
                   surface_points_.end(),
                   [](const Point& point) { return point.allFinite(); }))
    return refuse("the search surface has no finite point.");

  MultiScaleSettings settings = settings_;
  if (search_radius_ != 0)
    settings.max_radius = search_radius_;
  try {
    plan_ = multiScaleRadii(surface_points_, settings);
  }
  catch (const std::invalid_argument& error) {
    return refuse(error.what());
  }
  search_parameter_ = plan_.radii.back();
  return true;
}

template <typename PointInT>
void
MultiScaleShapeFeature<PointInT>::computeFeature(PointCloudOut& output)
{
  Points queries;
  queries.reserve(indices_->size());
  for (const pcl::index_t index : *indices_) {
    const PointInT& point = (*input_)[static_cast<std::size_t>(index)];
    queries.emplace_back(point.x, point.y, point.z);
  }
  MultiScaleSettings settings = settings_;
  settings.radii = radii_ = plan_.radii;
  settings.stop_change = 0; // it has had its say
  scale_unit_ = plan_.scale_unit;
  if (scale_unit_ > 0)
    settings.scale_unit = scale_unit_;
  ShapeGraphSink sink = sink_;
  if (keep_graphs_) {
    graphs_.reserve(queries.size());
    sink = [this](std::size_t query, const ShapeGraph& graph) {
      graphs_.push_back(graph);
      if (sink_)
        sink_(query, graph);
    };
  }
  const MultiScaleShapes result =
      multiScaleShapes(surface_points_, queries, settings, sink);
  surface_points_.clear();

  output.is_dense = true;
  for (std::size_t i = 0; i < result.shapes.size(); ++i) {
    output[i] = result.shapes[i];
    if (std::isnan(result.shapes[i].linearity))
      output.is_dense = false;
  }
  if (settings_.centroid == Centroid::QueryPoint) {
    noise_rate_ = linelet::noiseRate(result.shapes);
    noise_width_ = linelet::noiseWidth(result.shapes);
  }
}

} // namespace linelet
