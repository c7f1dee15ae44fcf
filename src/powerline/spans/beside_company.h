// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "powerline/pieces/piece.h"

namespace linelet::powerline {

/** \brief Offset of a wire from another: to the left and upward. */
struct Offset {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double spread = 0; ///< standard deviation of the mean, meters
};

/** \brief Offset of \a piece, with its known \a points, from \a company. */
Offset
offsetFrom(const SpanModel& company, const Piece& piece, const Points& points);

/** \brief Standard deviation of that offset between wires of one span, \a far meters
 * away. */
double
vagueAt(const Offset& offset, double far);

/** \brief Whether \a other hangs beside most of \a m. */
bool
isCompany(const SpanModel& m, const SpanModel& other);

} // namespace linelet::powerline
