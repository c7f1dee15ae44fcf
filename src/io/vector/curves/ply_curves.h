// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/curves/curve_network.h>

#include "io/source.h"

namespace linelet::io {

/** \brief The polylines of an ASCII PLY file (its edges), in its coordinates. \throws
 * FileError */
CurveNetwork
curvesFromPly(const Source& source);

/** \brief The curves of \a network as the text of an ASCII PLY file, with \a shift
 * added; those of fewer than two vertices are left out. */
std::string
curvesAsPly(const CurveNetwork& network, const Point& shift);

} // namespace linelet::io
