// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/io/file_error.h>
#include <linelet/io/file_options.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief Reads .las, .laz (and .copc.laz), .pcd, .ply, .h5, .xyz/.txt/.csv or the
 * vertices of .obj, by ending, and, if linelet::vector is linked, those of vector files
 * (.gpkg, .geojson, .shp, ...). A PATH.shift beside it (see \ref WriteOptions) is
 * added.
 * \param[in] path the file
 * \param[in] options see there
 * \param[out] warnings one sentence for everything lost; may be null
 * \throws FileError */
Cloud
readCloud(const std::string& path,
          const ReadOptions& options = {},
          std::vector<std::string>* warnings = nullptr,
          ProgressMonitor* monitor = nullptr);

/** \brief Writes \a cloud in the format that the ending of \a path names, and removes
 * the PATH.shift of an earlier cloud.
 * \param[out] warnings one sentence for every attribute the format cannot hold
 * \throws FileError */
void
writeCloud(const std::string& path,
           const Cloud& cloud,
           const WriteOptions& options = {},
           std::vector<std::string>* warnings = nullptr,
           ProgressMonitor* monitor = nullptr);

} // namespace io
} // namespace linelet
