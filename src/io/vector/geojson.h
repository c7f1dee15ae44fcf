// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/io/vector_file.h>

namespace linelet::io {

/** \brief A feature collection of all features, each with a property `layer`, in the
 * reference system \a wkt, named in the `crs` member (null if unknown) as before RFC
 * 7946. Not by GDAL, which does not name compound systems there. */
std::string
layersAsGeoJson(const std::vector<VectorLayer>& layers,
                const std::string& wkt,
                const ProgressMonitor* monitor = nullptr);

} // namespace linelet::io
