// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/io/file_summary.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief Writes a virtual point cloud (.vpc, a STAC item collection in GeoJSON) of \a
 * files, with their paths relative to its own folder.
 * \param[out] warnings one sentence for files without a reference system
 * \throws FileError */
void
writeVirtualCloud(const std::string& path,
                  const std::vector<FileSummary>& files,
                  std::vector<std::string>* warnings = nullptr);

} // namespace io
} // namespace linelet
