// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

#include <linelet/opencl/device.h>
#include <linelet/screen/screen_normals.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC opencl {

/** \brief \ref linelet::screenNormals on an OpenCL 1.2 device, with one work-item per
 * pixel; the normals agree within 1e-5. The host turns them toward the eye and smooths
 * them. Not for use by several threads at once. */
class ScreenNormalEngine {
public:
  /** \brief Opens a device, as \ref TensorEngine does. \throws Error */
  explicit ScreenNormalEngine(const std::string& device = {});
  ~ScreenNormalEngine();
  ScreenNormalEngine(ScreenNormalEngine&&) noexcept;
  ScreenNormalEngine&
  operator=(ScreenNormalEngine&&) noexcept;

  const Device&
  device() const;

  /** \brief See \ref linelet::screenNormals; settings.threads is for the host's part.
   * \throws Error */
  NormalImage
  estimate(const SampleLayers& samples,
           const Eigen::Vector3f& eye,
           const ScreenNormalSettings& settings);

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace opencl
} // namespace linelet
