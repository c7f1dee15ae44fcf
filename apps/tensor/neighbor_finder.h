// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/features/tensor_settings.h>

#include "device_engine.h"
#include "search_choice.h"

namespace linelet::apps {

/** \brief How neighbors are found, as requested and then as it ran. */
struct NeighborFinder {
  EngineOption engine = EngineOption::Auto;
  SearchOption search = SearchOption::Auto;
  std::string device;

  /** \brief The engine, or the PCL search used in its place. */
  std::string
  name() const
  {
    return std::string(isOfPcl(search) ? nameOf(search) : nameOf(engine));
  }

  /** \brief The engine that runs on the processor. */
  Engine
  onProcessor() const
  {
    return engine == EngineOption::Grid || engine == EngineOption::All ? Engine::Grid
                                                                       : Engine::Tree;
  }

  /** \brief Whether only the points of a piece are computed. */
  bool
  takesPieces() const
  {
    return engine != EngineOption::OpenCL && !isOfPcl(search);
  }
};

/** \brief The option for \a engine. */
inline EngineOption
optionOf(Engine engine)
{
  return engine == Engine::Grid ? EngineOption::Grid : EngineOption::Tree;
}

/** \brief Applies --search to the engine.
 * \throws std::runtime_error if --engine contradicts it */
void
settle(NeighborFinder& finder);

/** \brief The tensors of the queries by the engine or search in \a finder, which is no
 * longer EngineOption::Auto. */
std::vector<PointDistributionTensor>
tensorsWith(const NeighborFinder& finder,
            const Points& points,
            const Points& queries,
            TensorSettings settings,
            const NeighborhoodSizes& sizes,
            Frame& frame);

} // namespace linelet::apps
