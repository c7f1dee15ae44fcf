// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/support/points.h>

namespace linelet::io {

/** \brief The shift in PATH.shift, zero if there is none.
 * \throws FileError if it does not hold three numbers */
Point
readShift(const std::string& path);

/** \brief Writes \a shift to PATH.shift, or removes that file if the shift is zero.
 * \throws FileError */
void
writeShift(const std::string& path, const Point& shift);

} // namespace linelet::io
