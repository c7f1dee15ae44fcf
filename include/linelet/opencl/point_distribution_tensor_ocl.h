// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include <linelet/features/point_distribution_tensor.h>
#include <linelet/opencl/tensor_engine.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief \ref PointDistributionTensorEstimation on an OpenCL device.
 *
 * Same settings, same output, same rules for indices, search surface and points that
 * are not finite. There is no weighted median; setSearchMethod and setEngine have no
 * effect. The device is opened by the first compute and kept. If it fails, all records
 * are undefined (NaN) and the reason goes to PCL_ERROR. Prebuilt for the same point
 * types. */
template <typename PointInT>
class PointDistributionTensorEstimationOCL
    : public PointDistributionTensorEstimation<PointInT> {
  using Base = PointDistributionTensorEstimation<PointInT>;

public:
  using Ptr = pcl::shared_ptr<PointDistributionTensorEstimationOCL>;
  using ConstPtr = pcl::shared_ptr<const PointDistributionTensorEstimationOCL>;

  /** \param[in] device number or part of the name, see opencl::TensorEngine */
  explicit PointDistributionTensorEstimationOCL(std::string device = {});

  /** \brief The engine, for its device, its stage times and its memory limit.
   * \throws opencl::Error if the device cannot be opened */
  opencl::TensorEngine&
  getDeviceEngine();

protected:
  using Base::feature_name_;

  std::vector<PointDistributionTensor>
  estimate(const Points& surface,
           const Points& queries,
           const TensorSettings& settings,
           const NeighborhoodSizes& sizes) override;

private:
  std::string device_;
  std::shared_ptr<opencl::TensorEngine> engine_; // shared by copies, as PCL's trees are
};

extern template class PointDistributionTensorEstimationOCL<pcl::PointXYZ>;
extern template class PointDistributionTensorEstimationOCL<pcl::PointXYZI>;
extern template class PointDistributionTensorEstimationOCL<pcl::PointXYZRGB>;
extern template class PointDistributionTensorEstimationOCL<pcl::PointNormal>;
extern template class PointDistributionTensorEstimationOCL<pcl::PointXYZINormal>;

} // namespace linelet

#ifdef PCL_NO_PRECOMPILE
#include <linelet/opencl/impl/point_distribution_tensor_ocl.hpp>
#endif
