// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fragment_parts.h"

#include <limits>

namespace linelet::apps {

void
checkPartsOutput(CloudInput& input, CloudOutput& output)
{
  output.check(input);
  for (std::size_t i = 0; i < input.files().size(); ++i)
    if (!io::CloudSink::takes(output.pathFor(input, i)))
      throw io::FileError(output.pathFor(input, i) +
                          ": fragments are written to .las and .laz; name one of "
                          "these, or give more --memory");
}

CloudPiece
pieceOf(const fragments::Plan& plan, const fragments::Fragment& fragment)
{
  CloudPiece piece;
  const auto& core = fragment.core;
  const auto first = std::find(core.begin(), core.end(), true);
  const auto last = std::find(core.rbegin(), core.rend(), true);
  piece.begin = static_cast<std::size_t>(first - core.begin());
  piece.end = std::max(piece.begin, static_cast<std::size_t>(core.rend() - last));
  constexpr double none = std::numeric_limits<double>::infinity();
  piece.low = Point::Constant(none);
  piece.high = -piece.low;
  for (const fragments::PlannedInput& input : plan.inputs) {
    const fragments::Area& area = input.extent.area;
    if (!(input.extent.points > 0))
      continue;
    piece.low = piece.low.cwiseMin(Point(area.low[0], area.low[1], input.low_z));
    piece.high = piece.high.cwiseMax(Point(area.high[0], area.high[1], input.high_z));
  }
  piece.low -= plan.shift;
  piece.high -= plan.shift;
  return piece;
}

std::vector<std::size_t>
fragmentsOfInput(const fragments::Plan& plan, std::size_t number)
{
  if (number >= plan.inputs.size())
    return {};
  return plan.tiling.near(plan.inputs[number].extent.area, plan.reach());
}

} // namespace linelet::apps
