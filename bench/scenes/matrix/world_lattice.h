// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "world.h"

namespace linelet::bench::scenes {

/** \brief A lattice of \a bays between two squares (four corners each). */
void
addLattice(World& world,
           StructureKind kind,
           const Point (&bottom)[4],
           const Point (&top)[4],
           int bays,
           double radius);

} // namespace linelet::bench::scenes
