// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/features/point_types.h>
#include <linelet/features/tensor_settings.h>
#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::apps {

/** \brief The values of `--search`. */
enum class SearchOption {
  Auto,    ///< that of the engine
  Builtin, ///< linelet's kd-tree
  Grid,    ///< linelet's grid
  Flann,   ///< PCL's kd-tree, that of FLANN
  Octree   ///< PCL's octree
};

} // namespace linelet::apps

namespace linelet {

template <>
struct Names<apps::SearchOption> {
  static constexpr std::string_view kind = "search";
  static constexpr std::array<std::pair<apps::SearchOption, std::string_view>, 5>
      table = {{{apps::SearchOption::Auto, "auto"},
                {apps::SearchOption::Builtin, "builtin"},
                {apps::SearchOption::Grid, "grid"},
                {apps::SearchOption::Flann, "flann"},
                {apps::SearchOption::Octree, "octree"}}};
};

} // namespace linelet

namespace linelet::apps {

/** \brief Whether \a search is one of PCL's. */
inline bool
isOfPcl(SearchOption search)
{
  return search == SearchOption::Flann || search == SearchOption::Octree;
}

/** \brief The tensors of the queries with neighbors from a PCL search.
 * \throws std::runtime_error if linelet was built without PCL */
std::vector<PointDistributionTensor>
estimateWithPcl(SearchOption search,
                const Points& points,
                const Points& queries,
                const TensorSettings& settings,
                const NeighborhoodSizes& sizes,
                ProgressMonitor* monitor);

} // namespace linelet::apps
