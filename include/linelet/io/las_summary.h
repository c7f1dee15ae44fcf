// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief Everything in a LAS or LAZ file except its points. */
struct LasSummary {
  Point scale, offset;              ///< world = scale * integer + offset
  int copc_levels = 0;              ///< of the octree of a COPC file; 0: not COPC
  int epsg = 0;                     ///< code of the reference system; 0: unknown
  std::vector<std::string> records; ///< user, number and length of each
};

/** \brief The summary of the file that \a cloud came from; empty if it was not LAS. */
std::optional<LasSummary>
lasSummary(const Cloud& cloud);

} // namespace io
} // namespace linelet
