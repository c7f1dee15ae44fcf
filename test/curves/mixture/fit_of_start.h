// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/search/scale_unit.h>

#include "curves/mixture/em_fit.h"

namespace linelet {

/** \brief Fits \a start to \a points with a single bandwidth.
 * \param[in] least_noise in D
 * \param[in] settings that differ from the defaults; lengths are set from D */
inline EmFit
fitOf(const Points& points,
      const ModelCurve& start,
      double least_noise,
      EmSettings settings)
{
  const double unit = scaleUnit(points, 1024, 1, 1);
  const CloudFrame frame = frameOf(points, unit);
  const UniformGrid grid(points, 2 * unit);
  settings.spacing = 0.4 * unit;
  settings.noise = 0.5 * unit;
  settings.least_noise = least_noise * unit;
  settings.bending = 1 / frame.diagonal;
  return EmFitter(points, grid, frame).fit({start}, settings);
}

} // namespace linelet
