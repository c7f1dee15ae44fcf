// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <linelet/features/read_linearity_graph.h>

namespace linelet::test {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Radii 1, 2, 4, ...; every scale has enough neighbors unless counts are given.
inline LinearityGraph
read(const std::vector<double>& linearity,
     const LinearityGraphSettings& settings = {},
     std::vector<std::uint32_t> neighbors = {})
{
  std::vector<double> radii;
  for (std::size_t k = 0; k < linearity.size(); ++k)
    radii.push_back(std::exp2(static_cast<double>(k)));
  if (neighbors.empty())
    neighbors.assign(linearity.size(), 100);
  return readLinearityGraph(linearity, neighbors, radii, settings);
}

// Jitter peak, minimum at the jitter's size, maximum of the line, fall at a corner.
inline const std::vector<double> two_peaks = {0.9, 0.3, 0.8, 0.6, 0.2, 0.4};

} // namespace linelet::test
