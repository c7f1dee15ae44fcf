// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "io/source.h"

namespace linelet::io {

/** \brief The `v` lines of an OBJ file.
 *
 * \throws FileError, Canceled */
Cloud
readObjVertices(const Source& source);

/** \brief The points as `v` lines.
 *
 * \throws FileError, Canceled */
void
writeObjVertices(const Target& target, const Cloud& cloud);

} // namespace linelet::io
