// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

#include <linelet/curves/refined_reconstruction.h>

namespace linelet {

/** \brief Whether there is a spacing to go by. */
inline bool
hasScale(const CloudTraits& traits)
{
  return traits.scale_unit > 0 && std::isfinite(traits.scale_unit);
}

/** \brief Whether both ways are tried; a larger cloud is looked at first. */
inline bool
isSmall(const CloudTraits& traits)
{
  constexpr double most_tried_twice = 5000; // points
  return traits.points <= most_tried_twice;
}

/** \brief Whether a cloud is one of curves alone: around most of its points, it is
 * linear. */
inline bool
isOfCurvesAlone(const CloudTraits& traits)
{
  constexpr double curves_alone = 0.9;
  return traits.linear_share >= curves_alone;
}

} // namespace linelet
