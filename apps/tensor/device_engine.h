// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/features/engine_choice.h>
#include <linelet/features/point_types.h>

#include "frame.h"

namespace linelet::apps {

/** \brief What `--engine` names: the engines of the library, and that of a device. */
enum class EngineOption { Auto, Tree, Grid, OpenCL };

} // namespace linelet::apps

namespace linelet {

template <>
struct Names<apps::EngineOption> {
  static constexpr std::string_view kind = "engine";
  static constexpr std::array<std::pair<apps::EngineOption, std::string_view>, 4>
      table = {{{apps::EngineOption::Auto, "auto"},
                {apps::EngineOption::Tree, "tree"},
                {apps::EngineOption::Grid, "grid"},
                {apps::EngineOption::OpenCL, "opencl"}}};
};

} // namespace linelet

namespace linelet::apps {

/** \brief `--engine opencl`: the tensors of the queries from an OpenCL device, which is
 * named in the frame's summary together with the time of every stage.
 * \param[in] device number or part of a name, empty: the first GPU, else the first
 * \throws std::runtime_error where linelet was built without OpenCL, or has no device
 */
std::vector<PointDistributionTensor>
estimateOnDevice(const std::string& device,
                 const Points& points,
                 const Points& queries,
                 const TensorSettings& settings,
                 const NeighborhoodSizes& sizes,
                 Frame& frame);

/** \brief Whether `--engine auto` takes a GPU: there is one, and it is the cheapest. No
 * GPU was at hand to measure these costs: they are set high rather than low. */
bool
gpuIsCheapest(const std::string& device,
              const EngineWork& work,
              const TensorSettings& settings);

} // namespace linelet::apps
