// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <stdexcept>

#include <linelet/features/impl/shape_feature.hpp>
#include <linelet/features/multi_scale_shape.h>
#include <linelet/search/pcl_search.h>

namespace linelet {

template <typename PointInT>
MultiScaleShapeFeature<PointInT>::MultiScaleShapeFeature()
{
  feature_name_ = "MultiScaleShapeFeature";
}

template <typename PointInT>
void
MultiScaleShapeFeature<PointInT>::forget()
{
  graphs_.clear();
  radii_.clear();
  scale_unit_ = noise_rate_ = noise_width_ = std::numeric_limits<double>::quiet_NaN();
}

template <typename PointInT>
std::unique_ptr<NeighborSearch>
MultiScaleShapeFeature<PointInT>::givenSearch() const
{
  if (!tree_ || settings_.engine != ScaleEngine::Auto)
    return nullptr;
  return std::make_unique<PclSearch<PointInT>>(*tree_, surface_points_);
}

template <typename PointInT>
bool
MultiScaleShapeFeature<PointInT>::initCompute()
{
  forget();
  if (!this->initClouds())
    return false;
  if (k_ != 0)
    return this->refuse("a number of neighbors is set; the scales are radii.");
  if (search_radius_ != 0 && settings_.max_radius != 0)
    return this->refuse("both a search radius and a largest radius are set.");
  surface_points_ = pointsOf(*surface_);
  if (tree_ && tree_->getInputCloud() != surface_)
    tree_->setInputCloud(surface_);

  MultiScaleSettings settings = settings_;
  if (search_radius_ != 0)
    settings.max_radius = search_radius_;
  try {
    const auto search = givenSearch();
    plan_ = search ? multiScaleRadii(*search, surface_points_, settings, this->monitor_)
                   : multiScaleRadii(surface_points_, settings, this->monitor_);
  }
  catch (const std::invalid_argument& error) {
    return this->refuse(error.what());
  }
  catch (const Canceled&) {
    this->deinitCompute();
    throw;
  }
  search_parameter_ = plan_.radii.back();
  return true;
}

template <typename PointInT>
bool
MultiScaleShapeFeature<PointInT>::deinitCompute()
{
  surface_points_.clear();
  return Base::deinitCompute();
}

template <typename PointInT>
void
MultiScaleShapeFeature<PointInT>::computeFeature(PointCloudOut& output)
{
  const Points queries = this->queryPoints();
  MultiScaleSettings settings = settings_;
  settings.radii = radii_ = plan_.radii;
  settings.stop_change = 0; // already applied
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
  MultiScaleShapes result;
  try {
    const auto search = givenSearch();
    result =
        search ? multiScaleShapes(
                     *search, surface_points_, queries, settings, sink, this->monitor_)
               : multiScaleShapes(
                     surface_points_, queries, settings, sink, this->monitor_);
  }
  catch (const Canceled&) {
    this->deinitCompute(); // as PCL's compute would after this
    throw;
  }
  this->setOutput(output, result.shapes);
  if (settings_.centroid == Centroid::QueryPoint) {
    noise_rate_ = linelet::noiseRate(result.shapes);
    noise_width_ = linelet::noiseWidth(result.shapes);
  }
}

} // namespace linelet
