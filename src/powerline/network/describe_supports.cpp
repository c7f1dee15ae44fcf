// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/network/describe_supports.h"

#include <limits>

#include "powerline/supports/tower.h"

namespace linelet::powerline {

namespace {

// Without terrain the height is unknown; labeling the points then lowers the base to
// the lowest of them.
Support
describeSupport(const Tower& tower, int id, bool has_terrain)
{
  const Eigen::Vector2d& axis = tower.arm.center;
  Support support;
  support.id = id;
  support.kind = tower.pole ? Support::Kind::Pole : Support::Kind::Pylon;
  support.base = {axis.x(), axis.y(), has_terrain ? tower.base : tower.lowest_arm};
  support.top = {axis.x(), axis.y(), tower.top};
  support.height =
      has_terrain ? tower.top - tower.base : std::numeric_limits<double>::quiet_NaN();
  support.confidence = tower.confidence;
  return support;
}

} // namespace

std::vector<Support>
describeSupports(const std::vector<Tower>& towers, bool has_terrain)
{
  std::vector<Support> supports;
  for (const Tower& tower : towers)
    supports.push_back(
        describeSupport(tower, static_cast<int>(supports.size()) + 1, has_terrain));
  return supports;
}

} // namespace linelet::powerline
