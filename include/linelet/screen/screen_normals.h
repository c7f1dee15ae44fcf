// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include <linelet/screen/normal_image.h>
#include <linelet/screen/sample_layers.h>
#include <linelet/screen/screen_normal_settings.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The normals of what is visible, turned toward the eye.
 *
 * A pixel's own position is the mean of its samples within the distance limit of the
 * first one; it has a normal if enough samples surround it.
 * \param[in] eye where the samples are seen from, relative to their origin; for a
 * parallel projection any place far in front
 * \throws std::invalid_argument */
NormalImage
screenNormals(const SampleLayers& samples,
              const Eigen::Vector3f& eye,
              const ScreenNormalSettings& settings);

} // namespace linelet
