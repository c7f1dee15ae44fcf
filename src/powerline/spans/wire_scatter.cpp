// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/spans/wire_scatter.h"

namespace linelet::powerline {

ScanScatter
scatterOf(const std::vector<WireWithEnds>& wires, const Points& points)
{
  std::vector<ScanScatter::Sample> samples;
  for (const WireWithEnds& wire : wires)
    if (wire.strand.piece.thickness == 0)
      samples.push_back(sampleOf(wire.strand.piece, points));
  return ScanScatter(samples);
}

} // namespace linelet::powerline
