// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>

#include <linelet/curves/refined_settings.h>

#include "curves/mixture/em_fit.h"

namespace linelet {

/** \brief A component with fewer points holds no curve. */
inline constexpr std::size_t least_component = 5;

/** \brief Fits one connected component of a cloud: ridges at six bandwidths are
 * refitted, and the lowest score wins.
 *
 * For a large component, a few samples of it choose the bandwidth.
 * \param[in] points finite points
 * \param[in] scales how the spacing of the points varies; null: hardly at all
 * \param[in] stop called in every iteration of a fit; if it returns true, Canceled is
 * thrown
 * \param[in] progress called with the share of the work done
 * \return no curve if none explains the points better than uniform scatter does */
EmFit
refineComponent(const Points& points,
                const RefinedSettings& settings,
                const ScaleField* scales,
                const std::function<bool()>& stop,
                const std::function<void(double)>& progress);

} // namespace linelet
