// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <pcl/features/feature.h>
#include <pcl/memory.h>
#include <pcl/point_types.h>

#include <linelet/screen/screen_normals.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The normals of an organized cloud, from the pixels around each: \ref
 * screenNormals in a PCL chain, in place of pcl::IntegralImageNormalEstimation.
 *
 * Neighbors are pixels: no search method, radius or k takes part, and neither does a
 * search surface. Normals are turned towards the sensor's origin. Where there is none
 * (a point that is not finite, too few neighbors within the distance limit) it is NaN
 * and is_dense is false; curvature is NaN, it is not estimated. compute gives an empty
 * output, with a message through PCL_ERROR, if there is no input, the cloud is not
 * organized, or an index or a setting makes no sense.
 *
 * Prebuilt for PointXYZ, PointXYZI, PointXYZRGB, PointNormal and PointXYZINormal, with
 * pcl::Normal. For any other type define PCL_NO_PRECOMPILE before the first include. */
template <typename PointInT, typename PointOutT = pcl::Normal>
class ScreenSpaceNormalEstimation : public pcl::Feature<PointInT, PointOutT> {
  using Base = pcl::Feature<PointInT, PointOutT>;

public:
  using Ptr = pcl::shared_ptr<ScreenSpaceNormalEstimation>;
  using ConstPtr = pcl::shared_ptr<const ScreenSpaceNormalEstimation>;
  using PointCloudOut = typename Base::PointCloudOut;

  ScreenSpaceNormalEstimation();

  /** \brief What normals are made of, the tensor if not set. */
  void
  setMethod(ScreenNormalMethod method)
  {
    settings_.method = method;
  }
  ScreenNormalMethod
  getMethod() const
  {
    return settings_.method;
  }

  /** \brief Pixels that take part: 5, 9 (if not set), 17 or 25. */
  void
  setPattern(unsigned samples)
  {
    settings_.samples = samples;
  }
  unsigned
  getPattern() const
  {
    return settings_.samples;
  }

  /** \brief Points farther from a pixel's own take no part; 0 (if not set): all do. */
  void
  setMaxDistance(double distance)
  {
    settings_.max_distance = distance;
  }
  double
  getMaxDistance() const
  {
    return settings_.max_distance;
  }

  /** \brief Passes of smoothing, none if not set. */
  void
  setSmoothing(unsigned passes)
  {
    settings_.smoothing = passes;
  }
  unsigned
  getSmoothing() const
  {
    return settings_.smoothing;
  }

  /** \brief 0: what OpenMP offers. The result is the same for any number. */
  void
  setNumberOfThreads(unsigned nr_threads = 0)
  {
    settings_.threads = nr_threads;
  }
  unsigned
  getNumberOfThreads() const
  {
    return settings_.threads;
  }

protected:
  using Base::feature_name_;
  using Base::getClassName;
  using Base::indices_;
  using Base::input_;

  /** \brief In place of pcl::Feature's, which asks for a radius or k. */
  bool
  initCompute() override;

  /** \brief The normals; another engine overrides this. */
  virtual NormalImage
  estimate(const SampleLayers& samples, const Eigen::Vector3f& eye);

  ScreenNormalSettings settings_;

private:
  void
  computeFeature(PointCloudOut& output) override;

  bool
  refuse(const char* reason);
};

extern template class ScreenSpaceNormalEstimation<pcl::PointXYZ, pcl::Normal>;
extern template class ScreenSpaceNormalEstimation<pcl::PointXYZI, pcl::Normal>;
extern template class ScreenSpaceNormalEstimation<pcl::PointXYZRGB, pcl::Normal>;
extern template class ScreenSpaceNormalEstimation<pcl::PointNormal, pcl::Normal>;
extern template class ScreenSpaceNormalEstimation<pcl::PointXYZINormal, pcl::Normal>;

} // namespace linelet

#ifdef PCL_NO_PRECOMPILE
#include <linelet/screen/impl/screen_space_normal_estimation.hpp>
#endif
