// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/curves/curve_parts.h>

namespace linelet {

/** \brief The curves of a whole cloud as its only part, which cuts none. */
inline CurvePart
wholeAsPart(const CurveNetwork& network)
{
  return ownedBy(
      network, 0, [](const Point&) { return 0; }, 0);
}

} // namespace linelet
