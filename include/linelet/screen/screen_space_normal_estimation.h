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
 * screenNormals in a PCL pipeline, in place of pcl::IntegralImageNormalEstimation.
 *
 * Neighbors are pixels: search method, radius, k and search surface are not used.
 * Normals are turned toward the sensor's origin. Undefined normals (of a point that is
 * not finite, or has too few neighbors within the distance limit) are NaN, and is_dense
 * is then false; curvature is not estimated and is NaN. compute gives an empty output,
 * with a message through PCL_ERROR, if there is no input, the cloud is not organized,
 * or an index or a setting is invalid.
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

  /** \brief How normals are computed, by default from the tensor. */
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

  /** \brief Number of pixels sampled: 5, 9 (default), 17 or 25. */
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

  /** \brief Points farther than this from a pixel's own are ignored; 0 (default): none
   * are. */
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

  /** \brief Number of smoothing passes, 0 by default. */
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

  void
  setSettings(const ScreenNormalSettings& settings)
  {
    settings_ = settings;
  }
  const ScreenNormalSettings&
  getSettings() const
  {
    return settings_;
  }

protected:
  using Base::feature_name_;
  using Base::getClassName;
  using Base::indices_;
  using Base::input_;

  /** \brief Replaces pcl::Feature::initCompute, which requires a radius or k. */
  bool
  initCompute() override;

  /** \brief The normals; other engines override this. */
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
