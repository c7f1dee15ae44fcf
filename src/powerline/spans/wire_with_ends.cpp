// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/spans/wire_with_ends.h"

#include "powerline/pieces/growth.h"

namespace linelet::powerline {

void
release(const WireWithEnds& wire, Growth& growth)
{
  growth.claim(wire.strand.piece, Growth::nobody);
  for (const Piece& companion : wire.strand.companions)
    growth.claim(companion, Growth::nobody);
}

} // namespace linelet::powerline
