// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/read_linearity_graph.h>

#include <stdexcept>

#include "graph_reader.h"

namespace linelet {

LinearityGraph
readLinearityGraph(const std::vector<double>& linearity,
                   const std::vector<std::uint32_t>& neighbors,
                   const std::vector<double>& radii,
                   const LinearityGraphSettings& settings)
{
  if (linearity.size() != radii.size() || neighbors.size() != radii.size())
    throw std::invalid_argument(
        "readLinearityGraph: linearity, neighbors and radii differ in length");
  return GraphReader(radii, settings).read(linearity, neighbors);
}

} // namespace linelet
