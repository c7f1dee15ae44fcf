// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>

#include "line_lets.h"

namespace linelet {

/** \brief The points of two straight lines that are closest to each other. */
struct SkewLines {
  double on_first = 0;   ///< parameter on a + s u
  double on_second = 0;  ///< parameter on b + t v
  bool parallel = false; ///< then both parameters are 0
};

/** \brief Where the lines a + s u and b + t v come closest. */
SkewLines
closestOnSkewLines(const Point& a, const Point& u, const Point& b, const Point& v);

/** \brief Closes the end of line-let \a line on \a side if it has come within \a
 * distance of another line-let, or of a distant part of its own.
 *
 * If an open end is close by, both ends move to their mean and become one. Otherwise
 * the end is linked to a segment: the line of the last step and those of the two
 * segments at the nearest vertex are compared as skew lines; a closest point within a
 * segment becomes a vertex of it, else the nearest of the three vertices is used.
 * \return whether the end was closed */
bool
meet(LineLets& lets, Index line, LineLetSide side, double distance);

} // namespace linelet
