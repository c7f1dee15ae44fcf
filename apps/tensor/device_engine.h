// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/features/engine_choice.h>
#include <linelet/features/point_types.h>

#include "frame.h"

namespace linelet::apps {

/** \brief The values of `--engine`: the engines of the library, and those on
 * devices. */
enum class EngineOption {
  Auto,
  Tree,
  Grid,
  OpenCL,
  All ///< the grid and every OpenCL device, in fragments
};

} // namespace linelet::apps

namespace linelet {

template <>
struct Names<apps::EngineOption> {
  static constexpr std::string_view kind = "engine";
  static constexpr std::array<std::pair<apps::EngineOption, std::string_view>, 5>
      table = {{{apps::EngineOption::Auto, "auto"},
                {apps::EngineOption::Tree, "tree"},
                {apps::EngineOption::Grid, "grid"},
                {apps::EngineOption::OpenCL, "opencl"},
                {apps::EngineOption::All, "all"}}};
};

} // namespace linelet

namespace linelet::apps {

/** \brief An OpenCL device. Not for use by several threads at once. */
class DeviceEngine {
public:
  /** \param[in] device number or part of a name; empty: the first GPU, otherwise the
   * first device
   * \throws std::runtime_error if linelet was built without OpenCL or has no such
   * device */
  explicit DeviceEngine(const std::string& device);
  ~DeviceEngine();

  /** \brief The tensors of the queries. */
  std::vector<PointDistributionTensor>
  estimate(const Points& points,
           const Points& queries,
           const TensorSettings& settings,
           const NeighborhoodSizes& sizes,
           ProgressMonitor* monitor);

  /** \brief Records its name and the time of every stage of the last \ref estimate. */
  void
  summarize(nlohmann::ordered_json& summary) const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

/** \brief An OpenCL device of this machine. */
struct NamedDevice {
  std::string number; ///< as \ref DeviceEngine takes it
  std::string name;   ///< distinguishes it from the others
};

/** \brief All of them, or those with \a part in their names. */
std::vector<NamedDevice>
devicesNamed(const std::string& part);

/** \brief Whether `--engine auto` chooses a GPU: there is one, and it is the cheapest.
 * No GPU was at hand to measure these costs, so they are set high rather than low. */
bool
gpuIsCheapest(const std::string& device,
              const EngineWork& work,
              const TensorSettings& settings);

} // namespace linelet::apps
