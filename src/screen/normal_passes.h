// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include <linelet/screen/normal_image.h>
#include <linelet/screen/sample_layers.h>
#include <linelet/screen/screen_normal_settings.h>
#include <linelet/support/visibility.h>

#include "normal_kernels.h"

namespace linelet {
namespace LINELET_PUBLIC screen {

/** \brief The samples with margins, and every pixel's own position. */
PaddedSamples
padded(const SampleLayers& samples, double max_distance, int threads);

/** \brief An image without normals. */
NormalImage
emptyImage(const PaddedSamples& samples);

/** \brief Turns normals that look away from the eye. */
void
turnToEye(const PaddedSamples& samples,
          const Eigen::Vector3f& eye,
          NormalImage& image,
          int threads);

/** \brief Replaces normals, as often as the settings say, by weighted means over 3 x 3
 * pixels whose positions are close enough (weights 4, 2, 1 from the center). */
void
smooth(const PaddedSamples& samples,
       const ScreenNormalSettings& settings,
       NormalImage& image,
       int threads);

} // namespace screen
} // namespace linelet
