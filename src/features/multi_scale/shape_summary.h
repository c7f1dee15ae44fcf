// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <linelet/features/multi_scale_types.h>

#include "graph_reader.h"

namespace linelet {

/** \brief Where the graphs of a point are stored: one value per scale, \a stride values
 * apart.
 */
struct GraphColumns {
  const float* linearity;
  const float* planarity;
  const float* sphericity;
  const std::uint32_t* neighbors;
  std::size_t stride;
};

/** \brief Makes the records of points from their graphs. Holds buffers: make one per
 * thread and use it for many points. */
class ShapeSummary {
public:
  ShapeSummary(const std::vector<double>& radii,
               const LinearityGraphSettings& settings);

  /** \brief The record of a point, without its direction.
   * \param[in] here points of the surface that coincide with the query and are among
   * the neighbors at every scale */
  MultiScaleShape
  operator()(const GraphColumns& graph, std::uint32_t here);

private:
  std::vector<double> radii_;
  GraphReader reader_;
  std::vector<double> linearity_;
  std::vector<std::uint32_t> neighbors_;
};

} // namespace linelet
