// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/fittings/join_fittings.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace linelet::powerline {

void
numberFittings(PowerLineNetwork& network)
{
  std::vector<Jumper>& jumpers = network.jumpers;
  std::stable_sort(
      jumpers.begin(), jumpers.end(), [](const Jumper& a, const Jumper& b) {
        return std::tuple(a.support, a.from_wire) < std::tuple(b.support, b.from_wire);
      });
  int most = 0;
  for (const Jumper& jumper : jumpers)
    most = std::max(most, jumper.id);
  std::vector<int> now(static_cast<std::size_t>(most) + 1, 0);
  int id = 0;
  for (Jumper& jumper : jumpers) {
    now[static_cast<std::size_t>(jumper.id)] = ++id;
    jumper.id = id;
  }
  std::vector<InsulatorString>& strings = network.insulators;
  for (InsulatorString& string : strings)
    string.jumper =
        string.jumper > most ? 0 : now[static_cast<std::size_t>(string.jumper)];
  std::stable_sort(strings.begin(),
                   strings.end(),
                   [](const InsulatorString& a, const InsulatorString& b) {
                     return std::tuple(a.support, a.jumper, a.wire) <
                            std::tuple(b.support, b.jumper, b.wire);
                   });
  id = 0;
  for (InsulatorString& string : strings)
    string.id = ++id;
}

void
joinFittings(const std::vector<NetworkPart>& parts,
             const std::vector<PartIds>& ids,
             PowerLineNetwork& network)
{
  const auto owns = [](const NetworkPart& part, const Point& a, const Point& b) {
    return part.owns((a.x() + b.x()) / 2, (a.y() + b.y()) / 2);
  };
  int first = 0; // so that ids of jumpers differ from part to part until numbered
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const auto support = [&](int id) {
      return ids[p].supports.at(static_cast<std::size_t>(id));
    };
    const auto wire = [&](int id) {
      return ids[p].wires.at(static_cast<std::size_t>(id));
    };
    int last = first;
    for (const Jumper& one : parts[p].jumpers) {
      last = std::max(last, first + one.id);
      if (!owns(parts[p], one.course.front(), one.course.back()))
        continue;
      network.jumpers.push_back(one);
      Jumper& jumper = network.jumpers.back();
      jumper.id += first;
      jumper.support = support(one.support);
      jumper.from_wire = wire(one.from_wire);
      jumper.to_wire = wire(one.to_wire);
    }
    for (const InsulatorString& one : parts[p].insulators) {
      if (!owns(parts[p], one.structure, one.live))
        continue;
      network.insulators.push_back(one);
      InsulatorString& string = network.insulators.back();
      string.support = support(one.support);
      string.wire = wire(one.wire);
      if (one.jumper > 0)
        string.jumper += first;
    }
    first = last;
  }
  numberFittings(network);
}

} // namespace linelet::powerline
