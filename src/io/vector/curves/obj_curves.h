// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/curves/curve_network.h>

#include "io/source.h"

namespace linelet::io {

/** \brief The polylines of an OBJ file (v and l), in its coordinates. \throws FileError
 */
CurveNetwork
curvesFromObj(const Source& source);

/** \brief The curves of \a network as the text of an OBJ file, with \a shift added;
 * those of fewer than two vertices are left out. */
std::string
curvesAsObj(const CurveNetwork& network, const Point& shift);

} // namespace linelet::io
