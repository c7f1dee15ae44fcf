// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/features/register_point_distribution_tensor.h>
#include <linelet/features/shape_feature.h>
#include <linelet/features/tensor_estimation.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The neighborhood tensor of every point of a cloud, with its eigen-analysis
 * and shape factors: \ref estimateTensors in a PCL pipeline.
 *
 * Exactly one neighborhood size must be set: setRadiusSearch, setKSearch, \ref setRadii
 * or \ref setCounts. Points with d <= radius belong to a neighborhood, d computed in
 * double, the query point included where it is part of the surface.
 *
 * Neighbors come from the search given by setSearchMethod (any of them; PCL hands a
 * cloud to its search only when the pointer changes, so never alter a cloud in place),
 * else from a built-in grid or kd-tree; all find the same neighbors and give the same
 * result.
 *
 * The output has one record per query, in order. If a tensor is undefined, all floats
 * of the record are NaN and is_dense is false; `neighbors` is always the number found.
 * As everywhere in PCL, only the header of the cloud is carried over. compute gives an
 * empty output, with a message through PCL_ERROR, if there is no input, no finite point
 * in the surface, an index beyond the cloud, or a size of neighborhood that is not
 * positive and finite.
 *
 * Prebuilt for PointXYZ, PointXYZI, PointXYZRGB, PointNormal and PointXYZINormal. For
 * any other type define PCL_NO_PRECOMPILE before the first include, as for PCL's own
 * classes. */
template <typename PointInT>
class PointDistributionTensorEstimation
    : public ShapeFeature<PointInT, PointDistributionTensor, TensorSettings> {
  using Base = ShapeFeature<PointInT, PointDistributionTensor, TensorSettings>;

public:
  using Ptr = pcl::shared_ptr<PointDistributionTensorEstimation>;
  using ConstPtr = pcl::shared_ptr<const PointDistributionTensorEstimation>;
  using PointCloudOut = typename Base::PointCloudOut;

  PointDistributionTensorEstimation();

  /** \brief All parameters at once; a nonzero radius or k replaces that of
   * setRadiusSearch and setKSearch. */
  void
  setSettings(const TensorSettings& settings)
  {
    settings_ = settings;
    if (settings.radius != 0 || settings.k != 0) {
      search_radius_ = settings.radius;
      k_ = static_cast<int>(settings.k);
    }
  }
  /** \brief The parameters, with the size of neighborhood that PCL keeps. */
  TensorSettings
  getSettings() const;

  /** \brief What the sum over the neighbors is divided by, by default the sum of their
   * weights. */
  void
  setNormalization(Normalization normalization)
  {
    settings_.normalization = normalization;
  }
  Normalization
  getNormalization() const
  {
    return settings_.normalization;
  }

  /** \brief A radius for every point of the input cloud, whatever the indices; points
   * without a positive finite radius get NaN. Empty: none. */
  void
  setRadii(std::vector<double> radii)
  {
    sizes_.radii = std::move(radii);
  }
  const std::vector<double>&
  getRadii() const
  {
    return sizes_.radii;
  }

  /** \brief A number of nearest points for every point of the input cloud; 0 gives NaN.
   * Empty: none. */
  void
  setCounts(std::vector<unsigned> counts)
  {
    sizes_.counts = std::move(counts);
  }
  const std::vector<unsigned>&
  getCounts() const
  {
    return sizes_.counts;
  }

  /** \brief Auto: the search given by setSearchMethod, else the cheapest engine. Tree
   * and Grid do not use that search. */
  void
  setEngine(Engine engine)
  {
    settings_.engine = engine;
  }
  Engine
  getEngine() const
  {
    return settings_.engine;
  }

protected:
  using Base::feature_name_;
  using Base::getClassName;
  using Base::indices_;
  using Base::input_;
  using Base::k_;
  using Base::search_parameter_;
  using Base::search_radius_;
  using Base::settings_;
  using Base::surface_;
  using Base::tree_;

  bool
  initCompute() override;

  /** \brief The records of the queries; other engines override this. A std::exception
   * thrown by an override becomes a message and undefined records. */
  virtual std::vector<PointDistributionTensor>
  estimate(const Points& surface,
           const Points& queries,
           const TensorSettings& settings,
           const NeighborhoodSizes& sizes);

private:
  void
  computeFeature(PointCloudOut& output) override;

  /** \brief The sizes of the queries. */
  NeighborhoodSizes
  querySizes() const;

  NeighborhoodSizes sizes_; // of all points of the input
};

extern template class PointDistributionTensorEstimation<pcl::PointXYZ>;
extern template class PointDistributionTensorEstimation<pcl::PointXYZI>;
extern template class PointDistributionTensorEstimation<pcl::PointXYZRGB>;
extern template class PointDistributionTensorEstimation<pcl::PointNormal>;
extern template class PointDistributionTensorEstimation<pcl::PointXYZINormal>;

} // namespace linelet

#ifdef PCL_NO_PRECOMPILE
#include <linelet/features/impl/point_distribution_tensor.hpp>
#endif
