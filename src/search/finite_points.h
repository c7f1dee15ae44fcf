// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>

namespace linelet {

/** \brief Places of the finite ones among \a points, ascending. */
inline Indices
finiteOnes(const Points& points)
{
  Indices finite;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      finite.push_back(static_cast<Index>(i));
  return finite;
}

} // namespace linelet
