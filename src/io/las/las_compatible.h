// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>

#include "las_format.h"

namespace linelet::io {

/** \brief Whether the points are in the compatibility mode described below. */
bool
isCompatible(const LasOrigin& origin);

/** \brief Restores files in the compatibility mode of LASzip, which stores point
 * formats 6 to 10 as formats 1 to 5 of LAS 1.2 or 1.3, with extra bytes for what these
 * cannot hold: turns their columns into those of the original format, and drops the
 * extra entries.
 * \return that format; 0 for any other file, which is not changed */
int
restoreCompatible(Cloud& cloud, LasOrigin& origin);

} // namespace linelet::io
