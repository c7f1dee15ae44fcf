// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/curves/curve_network.h>

#include "io/source.h"

namespace linelet::io {

/** \brief The polylines of a file, in its coordinates, as \ref writeCurves writes them:
 * v and l of an OBJ, edges of an ASCII PLY, lines of an ASCII VTK file, rows of a CSV.
 * \throws FileError */
CurveNetwork
curvesFromObj(const Source& source);
CurveNetwork
curvesFromPly(const Source& source);
CurveNetwork
curvesFromVtk(const Source& source);
CurveNetwork
curvesFromCsv(const Source& source);

/** \brief The lines of all layers of a file that GDAL reads; points are left out.
 * \param[out] wkt its reference system, empty if it tells none; null: not wanted
 * \throws FileError */
CurveNetwork
curvesFromLayers(const Source& source, std::string* wkt);

/** \brief The curve through \a vertices: closed, with the last left out, where that is
 * the first. */
Curve
curveThrough(Points vertices);

} // namespace linelet::io
