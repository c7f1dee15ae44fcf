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

/** \brief Points of a file that follow one another, in its order. */
struct PointRange {
  std::size_t first = 0, count = 0;
};

/** \brief Where a COPC file (cloud optimized point cloud 1.0, copc.io) keeps the points
 * that may lie between X0,Y0 and X1,Y1, borders included: those of the nodes of its
 * octree that meet this. Nothing is decompressed.
 * \param[in] bounds X0, Y0, X1, Y1 in the coordinates of the file; may be infinite
 * \return in the order of the file, each beginning with a chunk; nothing where \a path
 * is no COPC file, or its octree does not tell of all chunks
 * \throws FileError where it cannot be read */
std::optional<std::vector<PointRange>>
copcRanges(const std::string& path, const std::array<double, 4>& bounds);

} // namespace io
} // namespace linelet
