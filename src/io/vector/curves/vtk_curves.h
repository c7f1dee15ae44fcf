// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/curves/curve_network.h>

#include "io/source.h"

namespace linelet::io {

/** \brief The polylines of an ASCII file of VTK (LINES), in its coordinates. \throws
 * FileError */
CurveNetwork
curvesFromVtk(const Source& source);

/** \brief The curves of \a network as the text of an ASCII file of VTK, with \a shift
 * added; those of fewer than two vertices are left out. */
std::string
curvesAsVtk(const CurveNetwork& network, const Point& shift);

} // namespace linelet::io
