// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/network/loose_wires.h"

#include <numeric>
#include <utility>

#include "powerline/pieces/span_model.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

NetworkPart
partOf(const PowerLineNetwork& network,
       const std::vector<WireWithEnds>& with_ends,
       std::vector<Wire> unnumbered,
       const std::vector<int>& ids,
       const Points& points)
{
  NetworkPart part;
  part.supports = network.supports;
  part.jumpers = network.jumpers;
  part.insulators = network.insulators;
  part.unexplained = network.unexplained;
  for (std::size_t w = 0; w < with_ends.size(); ++w) {
    LooseWire loose;
    loose.wire = std::move(unnumbered[w]);
    const Wire& numbered = network.wires[static_cast<std::size_t>(ids[w]) - 1];
    loose.wire.id = numbered.id;
    loose.wire.ground = numbered.ground;
    loose.wire.vegetation = numbered.vegetation;
    const SpanModel& m = with_ends[w].model();
    loose.course = {m.origin.x(),
                    m.origin.y(),
                    m.direction.x(),
                    m.direction.y(),
                    m.t[0],
                    m.t[1],
                    m.t[2],
                    m.z[0],
                    m.z[1],
                    m.z[2],
                    m.begin,
                    m.end,
                    m.sigma,
                    m.tolerance,
                    with_ends[w].strand.piece.thickness};
    for (const Index i : with_ends[w].strand.piece.members)
      loose.points.push_back(points[i]);
    for (std::size_t side = 0; side < 2; ++side) {
      const End& end = with_ends[w].ends[side];
      loose.ends[side] = {
          end.place, end.partner, end.partner_side, end.support, end.fixed};
    }
    part.wires.push_back(std::move(loose));
  }
  return part;
}

WireWithEnds
hungAgain(const LooseWire& loose)
{
  WireWithEnds wire;
  SpanModel& m = wire.strand.piece.model;
  const auto& c = loose.course;
  m.origin = {c[0], c[1]};
  m.direction = {c[2], c[3]};
  m.t = {c[4], c[5], c[6]};
  m.z = {c[7], c[8], c[9]};
  m.begin = c[10];
  m.end = c[11];
  m.sigma = c[12];
  m.tolerance = c[13];
  wire.strand.piece.thickness = c[14];
  wire.strand.piece.members.resize(loose.points.size());
  std::iota(wire.strand.piece.members.begin(), wire.strand.piece.members.end(), 0);
  for (std::size_t side = 0; side < 2; ++side) {
    const LooseWire::End& end = loose.ends[side];
    wire.ends[side].place = end.place;
    wire.ends[side].partner = end.partner;
    wire.ends[side].partner_side = end.partner_end;
    wire.ends[side].support = end.support;
    wire.ends[side].fixed = end.fixed;
  }
  return wire;
}

} // namespace linelet::powerline
