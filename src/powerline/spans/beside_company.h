// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "powerline/pieces/piece.h"

namespace linelet::powerline {

/** \brief How a wire hangs beside another: to the left and upwards. */
struct Offset {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double spread = 0; ///< standard deviation of the mean, meters
};

/** \brief How \a piece, of which \a points are known, hangs beside \a company. */
Offset
offsetFrom(const SpanModel& company, const Piece& piece, const Points& points);

/** \brief Standard deviation, at a place \a far meters away, of where a wire hangs
 * beside one of its span. */
double
vagueAt(const Offset& offset, double far);

/** \brief Whether \a other hangs beside most of \a m. */
bool
isCompany(const SpanModel& m, const SpanModel& other);

} // namespace linelet::powerline
