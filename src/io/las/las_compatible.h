// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>

#include "las_format.h"

namespace linelet::io {

/** \brief Whether the points are in the compatibility mode described below. */
bool
isCompatible(const LasOrigin& origin);

/** \brief Point formats 6 to 10 in the compatibility mode of LASzip are stored as 1 to
 * 5 of LAS 1.2 or 1.3, with what these cannot hold in extra bytes: turns the columns of
 * such a file into those of the format it stands for, and drops its extra entries.
 * \return that format; 0, without changes, for any other file */
int
restoreCompatible(Cloud& cloud, LasOrigin& origin);

} // namespace linelet::io
