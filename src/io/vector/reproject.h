// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/io/vector_file.h>

namespace linelet::io {

/** \brief Whether \a wkt is a reference system that is tied to the Earth. */
bool
isSystem(const std::string& wkt);

/** \brief \a layers, reprojected from the system \a from to \a to. Heights are
 * unchanged, except that they are in meters if \a to is in degrees.
 * \param[in] path for messages
 * \throws FileError if PROJ knows no transformation */
std::vector<VectorLayer>
reprojected(const std::string& path,
            std::vector<VectorLayer> layers,
            const std::string& from,
            const std::string& to);

} // namespace linelet::io
