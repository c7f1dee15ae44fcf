// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/features/multi_scale_settings.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The engine that \ref multiScaleShapes runs: for ScaleEngine::Auto, the one
 * that suits the numbers of points and queries, and the neighbors that a sample of the
 * queries has within the largest radius. */
ScaleEngine
chosenScaleEngine(const Points& surface,
                  const Points& queries,
                  double largest_radius,
                  const MultiScaleSettings& settings);

} // namespace linelet
