// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/false_positives/misled.h"

#include <algorithm>

#include "powerline/pieces/growth.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/least_hanging.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

namespace {

constexpr double farthest_off = 1.5; // meters, attachment point to wire

bool
isMisled(const WireWithEnds& wire)
{
  const SpanModel& m = wire.model();
  const double from = m.along(wire.ends[0].place), to = m.along(wire.ends[1].place);
  return to - from < leastHanging(m) ||
         std::max(m.distance(wire.ends[0].place), m.distance(wire.ends[1].place)) >
             farthest_off;
}

} // namespace

bool
dropMisled(std::vector<WireWithEnds>& wires, Growth& growth)
{
  const auto kept = std::stable_partition(
      wires.begin(), wires.end(), [](const WireWithEnds& w) { return !isMisled(w); });
  const bool any = kept != wires.end();
  for (auto wire = kept; wire != wires.end(); ++wire)
    release(*wire, growth);
  wires.erase(kept, wires.end());
  return any;
}

} // namespace linelet::powerline
