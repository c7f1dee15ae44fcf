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

/** \brief Whether both methods are tried; the method for a larger cloud is chosen
 * beforehand. */
inline bool
isSmall(const CloudTraits& traits)
{
  constexpr double most_tried_twice = 5000; // points
  return traits.points <= most_tried_twice;
}

/** \brief Whether a cloud is too small to show whether it is one of curves alone: of
 * few noisy points, curves often look no more linear than clutter. */
inline bool
isTiny(const CloudTraits& traits)
{
  constexpr double fewest_told = 1000; // points
  return traits.points < fewest_told;
}

inline constexpr double curves_alone = 0.9; ///< share of points linear around them

/** \brief Whether a cloud is one of curves alone: linear around most of its points. */
inline bool
isOfCurvesAlone(const CloudTraits& traits)
{
  return traits.linear_share >= curves_alone;
}

} // namespace linelet
