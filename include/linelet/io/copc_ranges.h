// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief Consecutive points of a file. */
struct PointRange {
  std::size_t first = 0, count = 0;
};

/** \brief Where a COPC file (cloud optimized point cloud 1.0, copc.io) keeps the points
 * that may lie between X0,Y0 and X1,Y1, borders included: those of the octree nodes
 * that intersect this area. Nothing is decompressed.
 * \param[in] bounds X0, Y0, X1, Y1 in the coordinates of the file; may be infinite
 * \return ranges in the order of the file, each beginning with a chunk; nothing if \a
 * path is not a COPC file, or its octree does not list all chunks
 * \throws FileError if it cannot be read */
std::optional<std::vector<PointRange>>
copcRanges(const std::string& path, const std::array<double, 4>& bounds);

} // namespace io
} // namespace linelet
