// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/curves/curve_network.h>

namespace linelet::io {

// The text of a file that holds the curves of \a network, with \a shift added; those of
// fewer than two vertices are no lines and left out.

std::string
curvesAsObj(const CurveNetwork& network, const Point& shift);

std::string
curvesAsPly(const CurveNetwork& network, const Point& shift);

std::string
curvesAsVtk(const CurveNetwork& network, const Point& shift);

std::string
curvesAsCsv(const CurveNetwork& network, const Point& shift);

} // namespace linelet::io
