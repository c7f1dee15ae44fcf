// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

#include <linelet/curves/refined_settings.h>

namespace linelet {

/** \brief Whether the spacing is defined. */
inline bool
hasScale(const CloudTraits& traits)
{
  return traits.scale_unit > 0 && std::isfinite(traits.scale_unit);
}

/** \brief Whether the cloud is small enough to try both methods; for a larger one the
 * method is chosen in advance. */
inline bool
isSmall(const CloudTraits& traits)
{
  constexpr double most_tried_twice = 5000; // points
  return traits.points <= most_tried_twice;
}

/** \brief Whether a cloud is too small to tell whether it holds only curves: with few
 * noisy points, curves often look no more linear than clutter. */
inline bool
isTiny(const CloudTraits& traits)
{
  constexpr double fewest_told = 1000; // points
  return traits.points < fewest_told;
}

inline constexpr double curves_alone = 0.9; ///< share of linear points

/** \brief Whether a cloud holds only curves: it is linear around most of its points. */
inline bool
isOfCurvesAlone(const CloudTraits& traits)
{
  return traits.linear_share >= curves_alone;
}

} // namespace linelet
