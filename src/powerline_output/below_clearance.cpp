// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline_output/below_clearance.h>

#include <algorithm>

namespace linelet::powerline {

bool
belowClearance(const Wire& wire, double limit)
{
  // Unknown clearances are NaN, which compares false.
  return wire.ground.distance < limit || wire.vegetation.distance < limit;
}

bool
clearancesAreUnknown(const PowerLineNetwork& network)
{
  return !network.wires.empty() &&
         std::none_of(network.wires.begin(), network.wires.end(), [](const Wire& wire) {
           return wire.ground.known() || wire.vegetation.known();
         });
}

std::optional<std::size_t>
wiresBelowClearance(const PowerLineNetwork& network, double limit)
{
  if (clearancesAreUnknown(network))
    return std::nullopt;
  return static_cast<std::size_t>(
      std::count_if(network.wires.begin(), network.wires.end(), [&](const Wire& wire) {
        return belowClearance(wire, limit);
      }));
}

} // namespace linelet::powerline
