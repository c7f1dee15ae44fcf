// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include <linelet/curves/curve_network.h>
#include <linelet/io/cloud.h>
#include <linelet/io/point_file.h>
#include <linelet/io/usable_points.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/search/uniform_grid.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::view {

/** \brief An axis-aligned box, relative to the shift of the cloud. */
struct Box {
  Point low = Point::Zero(), high = Point::Zero();

  bool
  contains(const Point& p) const
  {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  }
};

/** \brief The opened data. Never changes once made, so that threads may share it. */
struct Scene {
  std::vector<std::string> inputs; ///< as the user named them
  std::string folder;              ///< folder of results of `powerlines`, empty: none
  io::Cloud cloud;
  Points points;                     ///< those of the cloud, NaN if unused
  std::unique_ptr<UniformGrid> grid; ///< over \ref points; null without points
  double scale_unit = 0;             ///< D, NaN if the points have none
  Box bounds;                        ///< of points and curves
  CurveNetwork curves, truth;        ///< relative to the shift of the cloud
  std::shared_ptr<const powerline::PowerLineNetwork> lines; ///< null: none
  std::vector<std::string> warnings;
};

/** \brief Opens everything that linelet reads: point files, folders and lists of them,
 * curves, and folders written by `linelet powerlines`, all in one coordinate system.
 * \param[in] truth file of true curves, empty: none
 * \throws io::FileError, Canceled */
std::shared_ptr<const Scene>
openScene(const std::vector<std::string>& paths,
          const std::string& truth = {},
          const io::ReadOptions& options = {},
          const io::ClassFilter& classes = {},
          ProgressMonitor* monitor = nullptr);

/** \brief Whether \a folder holds results of `powerlines`. */
bool
isPowerLineFolder(const std::string& folder);

/** \brief The network in the summary.json and classified cloud of a folder, without
 * terrain.
 * \throws io::FileError */
powerline::PowerLineNetwork
readNetwork(const std::string& folder, const io::Cloud& classified);

} // namespace linelet::view
