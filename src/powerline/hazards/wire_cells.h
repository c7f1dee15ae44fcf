// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <linelet/powerline/power_line_network.h>

namespace linelet::powerline {

/** \brief Square cells in plan with the wires that come within reach of each, so that
 * few wires are tested per point. */
class WireCells {
public:
  /** \param[in] reach meters in plan, > 0 */
  WireCells(const std::vector<Wire>& wires, double reach);

  /** \brief Indices in the list of wires, ascending: all within reach of \a p in plan,
   * and some others. */
  const std::vector<std::uint32_t>&
  near(const Point& p) const
  {
    static const std::vector<std::uint32_t> none;
    const auto found = cells_.find(key(cell(p.x()), cell(p.y())));
    return found == cells_.end() ? none : found->second;
  }

private:
  std::int64_t
  cell(double coordinate) const
  {
    return static_cast<std::int64_t>(std::floor(coordinate / side_));
  }

  static std::uint64_t
  key(std::int64_t column, std::int64_t row)
  {
    return static_cast<std::uint64_t>(column) << 32 ^
           (static_cast<std::uint64_t>(row) & 0xffffffffU);
  }

  double side_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

} // namespace linelet::powerline
