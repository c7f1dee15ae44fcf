// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <linelet/features/multi_scale.h>
#include <linelet/features/noise_rate.h>
#include <linelet/features/register_multi_scale_shape.h>
#include <linelet/features/shape_feature.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The multi-scale shape feature of a cloud: \ref multiScaleShapes in a PCL
 * chain.
 *
 * Nothing has to be set: the radii follow from the scale unit D of the surface.
 * setRadiusSearch, which other features need, gives the largest radius here, as \ref
 * setMaxRadius does; setKSearch is not supported. Neighbors come from the search given
 * by setSearchMethod (any of them), else from a built-in grid, which is faster: one
 * query at the largest radius serves all scales. All find the same neighbors. With the
 * engine set to sweep or grid, the search is not used.
 *
 * The output has one record per query, in order. Undefined values are NaN, and is_dense
 * is then false; as everywhere in PCL, only the header of the cloud is carried over.
 * compute gives an empty output, with a message through PCL_ERROR, if there is no
 * input, no finite point in the surface, an index beyond the cloud, or a parameter out
 * of range.
 *
 * Prebuilt for PointXYZ, PointXYZI, PointXYZRGB, PointNormal and PointXYZINormal. For
 * any other type define PCL_NO_PRECOMPILE before the first include, as for PCL's own
 * classes. */
template <typename PointInT>
class MultiScaleShapeFeature
    : public ShapeFeature<PointInT, MultiScaleShape, MultiScaleSettings> {
  using Base = ShapeFeature<PointInT, MultiScaleShape, MultiScaleSettings>;

public:
  using Ptr = pcl::shared_ptr<MultiScaleShapeFeature>;
  using ConstPtr = pcl::shared_ptr<const MultiScaleShapeFeature>;
  using PointCloudOut = typename Base::PointCloudOut;

  MultiScaleShapeFeature();

  /** \brief All parameters at once. */
  void
  setSettings(const MultiScaleSettings& settings)
  {
    settings_ = settings;
  }
  const MultiScaleSettings&
  getSettings() const
  {
    return settings_;
  }

  /** \brief The largest radius in the unit of the cloud; 0: 60 D. */
  void
  setMaxRadius(double radius)
  {
    settings_.max_radius = radius;
  }
  double
  getMaxRadius() const
  {
    return settings_.max_radius;
  }

  /** \brief How the radii grow, exponentially by default. */
  void
  setGrowth(RadiusGrowth growth)
  {
    settings_.growth = growth;
  }
  RadiusGrowth
  getGrowth() const
  {
    return settings_.growth;
  }

  /** \brief Radii of the scales, ascending, instead of growth and largest radius.
   * Empty: none. */
  void
  setRadii(std::vector<double> radii)
  {
    settings_.radii = std::move(radii);
  }

  /** \brief Whether compute keeps the graphs of every query, on by default: 28 bytes
   * per point and scale, 308 MB for a million points and 11 scales. */
  void
  setKeepGraphs(bool keep)
  {
    keep_graphs_ = keep;
  }
  bool
  getKeepGraphs() const
  {
    return keep_graphs_;
  }

  /** \brief Receives the graphs of every query as they are computed, in order; see
   * ShapeGraphSink. */
  void
  setGraphSink(ShapeGraphSink sink)
  {
    sink_ = std::move(sink);
  }

  /** \brief CL, CP, CS, neighbors and direction of every query at every radius of the
   * last compute; empty after setKeepGraphs(false). */
  const std::vector<ShapeGraph>&
  getGraphs() const
  {
    return graphs_;
  }

  /** \brief The radii of the last compute, ascending. */
  const std::vector<double>&
  getRadii() const
  {
    return radii_;
  }

  /** \brief D of the last compute. */
  double
  getScaleUnit() const
  {
    return scale_unit_;
  }

  /** \brief Noise rate of the queries of the last compute, see linelet::noiseRate; NaN
   * unless the centroid was the query point, for which it is defined. */
  double
  getNoiseRate() const
  {
    return noise_rate_;
  }

  /** \brief Noise width likewise, see linelet::noiseWidth. */
  double
  getNoiseWidth() const
  {
    return noise_width_;
  }

  /** \name Short names
   * The same as the getters. */
  ///@{
  const std::vector<ShapeGraph>&
  graphs() const
  {
    return getGraphs();
  }
  const std::vector<double>&
  radii() const
  {
    return getRadii();
  }
  double
  noiseRate() const
  {
    return getNoiseRate();
  }
  ///@}

protected:
  using Base::feature_name_;
  using Base::k_;
  using Base::search_parameter_;
  using Base::search_radius_;
  using Base::settings_;
  using Base::surface_;
  using Base::tree_;

  bool
  initCompute() override;

  bool
  deinitCompute() override;

private:
  void
  computeFeature(PointCloudOut& output) override;

  void
  forget();

  /** \brief The search that was given, if it is to be used; else null. */
  std::unique_ptr<NeighborSearch>
  givenSearch() const;

  bool keep_graphs_ = true;
  ShapeGraphSink sink_;

  Points surface_points_; // between initCompute and computeFeature
  MultiScaleShapes plan_; // radii and scale unit of the surface
  std::vector<ShapeGraph> graphs_;
  std::vector<double> radii_;
  double scale_unit_ = std::numeric_limits<double>::quiet_NaN();
  double noise_rate_ = std::numeric_limits<double>::quiet_NaN();
  double noise_width_ = std::numeric_limits<double>::quiet_NaN();
};

extern template class MultiScaleShapeFeature<pcl::PointXYZ>;
extern template class MultiScaleShapeFeature<pcl::PointXYZI>;
extern template class MultiScaleShapeFeature<pcl::PointXYZRGB>;
extern template class MultiScaleShapeFeature<pcl::PointNormal>;
extern template class MultiScaleShapeFeature<pcl::PointXYZINormal>;

} // namespace linelet

#ifdef PCL_NO_PRECOMPILE
#include <linelet/features/impl/multi_scale_shape.hpp>
#endif
