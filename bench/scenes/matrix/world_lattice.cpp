// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "world_lattice.h"

#include <bench/scenes/lattice.h>

namespace linelet::bench::scenes {

void
addLattice(World& world,
           StructureKind kind,
           const Point (&bottom)[4],
           const Point (&top)[4],
           int bays,
           double radius)
{
  forEachLatticeBar(
      bottom, top, bays, [&](const Point& from, const Point& to, double share) {
        world.add(kind, from, to, share * radius);
      });
}

} // namespace linelet::bench::scenes
