// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>

#include "las_format.h"

namespace linelet::io {

/** \brief Whether the points are those of such a mode, see below. */
bool
isCompatible(const LasOrigin& origin);

/** \brief Point formats 6 to 10 in the compatibility mode of LASzip are stored as 1 to
 * 5 of LAS 1.2 or 1.3, with what these cannot hold in extra bytes: makes of the columns
 * of such a file those of the format it stands for, and forgets its extra entries.
 * \return that format; 0, and nothing done, for any other file */
int
restoreCompatible(Cloud& cloud, LasOrigin& origin);

} // namespace linelet::io
