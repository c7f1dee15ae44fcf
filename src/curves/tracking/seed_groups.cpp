// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "seed_groups.h"

#include <array>
#include <map>

namespace linelet {

SeedGroups::SeedGroups(const std::vector<TrackSeed>& seeds, double side)
    : seeds_(seeds), cell_of_(seeds.size())
{
  std::map<std::array<double, 3>, std::size_t> numbers;
  for (std::size_t k = seeds.size(); k-- > 0;) {
    const Point cell = (seeds[k].at / side).array().floor();
    const auto [at, is_new] =
        numbers.try_emplace({cell.x(), cell.y(), cell.z()}, cells_.size());
    if (is_new)
      cells_.emplace_back();
    cell_of_[k] = at->second;
    cells_[at->second].push_back(k);
  }
}

std::vector<TrackSeed>
SeedGroups::next(std::size_t most, const std::function<bool(const TrackSeed&)>& is_open)
{
  std::vector<TrackSeed> group;
  for (; best_ < seeds_.size() && group.empty() && most > 0; ++best_) {
    std::vector<std::size_t>& left = cells_[cell_of_[best_]];
    if (left.empty() || left.back() != best_)
      continue; // already in another group
    while (!left.empty() && group.size() < most) {
      const TrackSeed& seed = seeds_[left.back()];
      const bool is_first = group.empty();
      const bool open = is_open(seed);
      left.pop_back();
      ++passed_;
      if (open)
        group.push_back(seed);
      else if (is_first)
        break; // the best of all may be elsewhere
    }
  }
  return group;
}

} // namespace linelet
