// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <pcl/console/print.h>

#include <linelet/features/shape_feature.h>

namespace linelet {

template <typename PointInT, typename RecordT, typename Settings>
bool
ShapeFeature<PointInT, RecordT, Settings>::refuse(const char* reason)
{
  PCL_ERROR("[linelet::%s::compute] %s\n", getClassName().c_str(), reason);
  this->deinitCompute();
  return false;
}

template <typename PointInT, typename RecordT, typename Settings>
bool
ShapeFeature<PointInT, RecordT, Settings>::initClouds()
{
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
  const bool any_finite =
      std::any_of(surface_->begin(), surface_->end(), [](const PointInT& point) {
        return std::isfinite(point.x) && std::isfinite(point.y) &&
               std::isfinite(point.z);
      });
  return any_finite || refuse("the search surface has no finite point.");
}

template <typename PointInT, typename RecordT, typename Settings>
Points
ShapeFeature<PointInT, RecordT, Settings>::queryPoints() const
{
  Points queries;
  queries.reserve(indices_->size());
  for (const pcl::index_t index : *indices_) {
    const PointInT& point = (*input_)[static_cast<std::size_t>(index)];
    queries.emplace_back(point.x, point.y, point.z);
  }
  return queries;
}

template <typename PointInT, typename RecordT, typename Settings>
void
ShapeFeature<PointInT, RecordT, Settings>::setOutput(
    PointCloudOut& output, const std::vector<RecordT>& records)
{
  std::copy(records.begin(), records.end(), output.begin());
  output.is_dense =
      std::none_of(records.begin(), records.end(), [](const RecordT& record) {
        return std::isnan(record.linearity);
      });
}

} // namespace linelet
