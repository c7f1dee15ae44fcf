// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/support/face.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief Writes faces as binary PLY, for CloudCompare, MeshLab, ParaView or Blender:
 * each shared corner once, and the corners, normal and part of every face.
 * \param[in] shift added to the corners
 * \throws FileError */
void
writeMesh(const std::string& path, const std::vector<Face>& faces, const Point& shift);

} // namespace io
} // namespace linelet
