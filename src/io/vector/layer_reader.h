// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/curves/curve_network.h>

#include "io/source.h"

namespace linelet::io {

/** \brief The lines of all layers of a file that GDAL reads, including outlines of
 * areas; points are left out.
 * \param[out] wkt its reference system, empty if it has no CRS; may be null
 * \throws FileError */
CurveNetwork
curvesFromLayers(const Source& source, std::string* wkt);

} // namespace linelet::io
