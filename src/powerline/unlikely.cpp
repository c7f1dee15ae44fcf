// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include "powerline/joints.h"

namespace linelet::powerline {

namespace {

constexpr double alone_length = 25;  // metres, a lonely wire must be longer
constexpr double company_reach = 14; // metres
constexpr double company_part = 0.5; // of the length
constexpr double steep = 0.12;       // slope between the ends
constexpr double straight = 5e-5;    // 1/metres; a wire with a = 10 km

bool
hasPartner(const Hanging& wire)
{
  return wire.ends[0].partner >= 0 || wire.ends[1].partner >= 0;
}

bool
unlikely(const std::vector<Hanging>& wires, std::size_t w)
{
  const SpanModel& m = wires[w].model();
  if (hasPartner(wires[w]))
    return false;
  const double slope =
      std::abs(SpanModel::value(m.z, m.end) - SpanModel::value(m.z, m.begin)) /
      m.length();
  if (slope > steep &&
      m.z[2] - 2 * m.uncertainty(0) / (m.length() * m.length()) < straight)
    return true;
  if (m.length() >= alone_length)
    return false;
  return std::none_of(wires.begin(), wires.end(), [&](const Hanging& other) {
    if (&other == &wires[w])
      return false;
    const Parallel parallel = compare(m, other.model());
    return parallel.overlap >= company_part * m.length() &&
           parallel.distance <= company_reach;
  });
}

} // namespace

void
dropUnlikely(std::vector<Hanging>& wires, Growth& growth)
{
  std::vector<int> place(wires.size(), -1);
  std::vector<Hanging> kept;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    if (!unlikely(wires, w)) {
      place[w] = static_cast<int>(kept.size());
      kept.push_back(wires[w]);
      continue;
    }
    growth.claim(wires[w].strand.piece, Growth::nobody);
    for (const Piece& companion : wires[w].strand.companions)
      growth.claim(companion, Growth::nobody);
  }
  // Who has a partner is kept, and so is the partner.
  for (Hanging& wire : kept)
    for (End& end : wire.ends)
      if (end.partner >= 0)
        end.partner = place[static_cast<std::size_t>(end.partner)];
  wires = std::move(kept);
}

} // namespace linelet::powerline
