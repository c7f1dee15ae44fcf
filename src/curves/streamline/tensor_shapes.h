// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/curves/streamline_settings.h>
#include <linelet/features/multi_scale_types.h>

namespace linelet {

/** \brief Features of points whose tensors are given: graphs of one scale, whose blend
 * is the linearity. NaN if a tensor has no shape. */
MultiScaleShapes
shapesOfTensors(const std::vector<SymmetricTensor>& tensors,
                double scale_unit,
                const StreamlineSettings& settings);

} // namespace linelet
