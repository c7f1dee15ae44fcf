// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace linelet::io {

/** \brief The driver of GDAL that writes layers to \a path, by its ending; empty if
 * there is none. */
std::string
findLayerDriver(const std::string& path);

/** \brief The same. \throws FileError if there is none */
std::string
layerDriver(const std::string& path);

/** \brief The driver that reads layers from \a path: one that writes them, or that of
 * shapefiles. Empty if there is none. */
std::string
findReadLayerDriver(const std::string& path);

} // namespace linelet::io
