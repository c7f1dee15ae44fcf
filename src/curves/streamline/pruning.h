// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "cloud_neighbors.h"

#include "line_lets.h"

namespace linelet {

/** \brief Cuts open ends back to where a point is within \a distance. Vertices at which
 * line-lets are joined stay. */
void
pruneOpenEnds(LineLets& lets, const CloudNeighbors& neighbors, double distance);

} // namespace linelet
