// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/support/points.h>

namespace linelet::io {

/** \brief The shift in the file beside \a path, zero where there is none.
 * \throws FileError if it does not hold three numbers */
Point
readShift(const std::string& path);

/** \brief Puts \a shift beside \a path, or takes away what is there if it is zero.
 * \throws FileError */
void
writeShift(const std::string& path, const Point& shift);

} // namespace linelet::io
