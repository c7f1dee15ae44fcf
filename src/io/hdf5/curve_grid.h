// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/curves/curve_network.h>
#include <linelet/support/points.h>

#include "handle.h"

namespace linelet::io::hdf5 {

/** \brief Writes \a network as the grid of curves of \a file. */
void
writeCurveGrid(const Handle& file,
               const CurveNetwork& network,
               const Point& shift,
               const std::string& wkt);

/** \brief Reads it back, in world coordinates. \throws Error if it is damaged */
CurveNetwork
readCurveGrid(const Handle& file, std::string* wkt);

} // namespace linelet::io::hdf5
