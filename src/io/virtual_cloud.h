// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace linelet::io {

/** \brief The point files that the virtual point cloud \a path names.
 * \throws FileError */
std::vector<std::string>
filesOfVirtualCloud(const std::string& path);

} // namespace linelet::io
