// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>

namespace linelet {

/** \brief Major eigenvector of a symmetric positive semidefinite \a matrix by repeated
 * squaring, oriented like \a like, which is returned if the matrix has no major
 * direction. */
Point
majorDirection(const Eigen::Matrix3d& matrix, const Point& like);

} // namespace linelet
