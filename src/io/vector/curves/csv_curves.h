// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/curves/curve_network.h>

#include "io/source.h"

namespace linelet::io {

/** \brief The polylines of a CSV file with one row per vertex, in its coordinates.
 * \throws FileError */
CurveNetwork
curvesFromCsv(const Source& source);

/** \brief The curves of \a network as the text of a CSV file, with \a shift added;
 * those of fewer than two vertices are left out. */
std::string
curvesAsCsv(const CurveNetwork& network, const Point& shift);

} // namespace linelet::io
