// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/io/vector_file.h>

namespace linelet::io {

/** \brief A feature collection of all features, each with a property `layer`, in the
 * reference system \a wkt, which its `crs` member names, null where it is unknown: as
 * before RFC 7946, and not by GDAL, which names no compound systems there. */
std::string
layersAsGeoJson(const std::vector<VectorLayer>& layers,
                const std::string& wkt,
                const ProgressMonitor* monitor = nullptr);

} // namespace linelet::io
