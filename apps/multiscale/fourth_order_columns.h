// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>
#include <utility>

#include <linelet/features/multi_scale_settings.h>
#include <linelet/io/cloud.h>
#include <linelet/support/names.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::apps {

/** \brief The value of `--fourth-order`: whether the tensor is written, and its
 * weight. */
enum class FourthOrderOption { None, Linearity, Planarity, Sphericity, Uniform };

} // namespace linelet::apps

namespace linelet {

template <>
struct Names<apps::FourthOrderOption> {
  static constexpr std::string_view kind = "weight of the fourth-order tensor";
  static constexpr std::array<std::pair<apps::FourthOrderOption, std::string_view>, 5>
      table = {{{apps::FourthOrderOption::None, "none"},
                {apps::FourthOrderOption::Linearity, "linearity"},
                {apps::FourthOrderOption::Planarity, "planarity"},
                {apps::FourthOrderOption::Sphericity, "sphericity"},
                {apps::FourthOrderOption::Uniform, "uniform"}}};
};

} // namespace linelet

namespace linelet::apps {

/** \brief Adds the fourth-order tensors of \a points, one per point of \a cloud, as
 * attributes: 21 components in Mandel's notation, t4_xx_xx to t4_xy_xy, and the major
 * eigentensor, major_xx to major_zz; NaN where there is none. */
void
addFourthOrder(io::Cloud& cloud,
               const Points& points,
               const MultiScaleSettings& settings,
               FourthOrderOption weight,
               ProgressMonitor* monitor);

} // namespace linelet::apps
