// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/supports/place_order.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "powerline/spans/wire_with_ends.h"
#include "powerline/supports/tower.h"

namespace linelet::powerline {

namespace {

/** Sorts \a list into \a order. \return the new index of each entry */
template <class T>
std::vector<int>
sortInto(const std::vector<std::size_t>& order, std::vector<T>& list)
{
  std::vector<int> now(list.size());
  std::vector<T> sorted;
  sorted.reserve(list.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    now[order[k]] = static_cast<int>(k);
    sorted.push_back(std::move(list[order[k]]));
  }
  list = std::move(sorted);
  return now;
}

template <class Key>
std::vector<std::size_t>
orderOf(const std::vector<Key>& keys)
{
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return keys[a] < keys[b];
  });
  return order;
}

} // namespace

std::vector<std::size_t>
orderByPlace(const std::vector<WireWithEnds>& wires)
{
  using Key = std::array<double, 6>;
  std::vector<Key> keys;
  for (const WireWithEnds& wire : wires) {
    const Point &a = wire.ends[0].place, &b = wire.ends[1].place;
    const Key forward = {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
    const Key back = {b.x(), b.y(), b.z(), a.x(), a.y(), a.z()};
    keys.push_back(std::min(forward, back));
  }
  return orderOf(keys);
}

void
sortByPlace(std::vector<WireWithEnds>& wires, std::vector<Tower>& towers)
{
  const std::vector<int> wire_at = sortInto(orderByPlace(wires), wires);
  std::vector<std::array<double, 2>> axes;
  for (const Tower& tower : towers)
    axes.push_back({tower.arm.center.x(), tower.arm.center.y()});
  const std::vector<int> tower_at = sortInto(orderOf(axes), towers);
  for (WireWithEnds& wire : wires)
    for (End& end : wire.ends) {
      if (end.partner >= 0)
        end.partner = wire_at[static_cast<std::size_t>(end.partner)];
      if (end.support >= 0)
        end.support = tower_at[static_cast<std::size_t>(end.support)];
    }
  for (Tower& tower : towers)
    for (auto& end : tower.ends)
      end.first = wire_at[static_cast<std::size_t>(end.first)];
}

} // namespace linelet::powerline
