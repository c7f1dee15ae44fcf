// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/features/tensor_settings.h>

#include "device_engine.h"
#include "search_choice.h"

namespace linelet::apps {

/** \brief Who finds the neighbors, as asked for and then as it ran. */
struct NeighborFinder {
  EngineOption engine = EngineOption::Auto;
  SearchOption search = SearchOption::Auto;
  std::string device;

  /** \brief The engine, or the search of PCL that stood in its place. */
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

  /** \brief Whether the points of a piece are all that it computes. */
  bool
  takesPieces() const
  {
    return engine != EngineOption::OpenCL && !isOfPcl(search);
  }
};

/** \brief The option that stands for \a engine. */
inline EngineOption
optionOf(Engine engine)
{
  return engine == Engine::Grid ? EngineOption::Grid : EngineOption::Tree;
}

/** \brief Makes of --search what it says about the engine.
 * \throws std::runtime_error where --engine says another thing */
void
settle(NeighborFinder& finder);

/** \brief The tensors of the queries by the engine or search that \a finder names,
 * which is no longer EngineOption::Auto. */
std::vector<PointDistributionTensor>
tensorsWith(const NeighborFinder& finder,
            const Points& points,
            const Points& queries,
            TensorSettings settings,
            const NeighborhoodSizes& sizes,
            Frame& frame);

} // namespace linelet::apps
