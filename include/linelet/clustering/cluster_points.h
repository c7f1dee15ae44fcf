// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/clustering/cluster_settings.h>
#include <linelet/clustering/clusters.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Clusters points in a grid whose cells adapt to them (Schiffner et al. 2014).
 *
 * Points are sorted into the cells of a grid, uniform in space or in the view of a
 * camera. Then those near a border may move to the cell across it: only indices change,
 * and the grid becomes curvilinear. A point moves only across its nearest border, and
 * only into a cell that holds points, so it never ends up more than one cell from its
 * own, and no new cells appear. All decisions of a pass are based on the state before
 * it.
 *
 * The exact rule of the publication is not available to us; these are our own:
 * - MoveRule::Plane: to the cell whose plane (mean and smallest eigenvector of the
 *   members' covariance) is nearer. The sum of squared distances to the planes never
 *   rises.
 * - MoveRule::Population: to the less populated cell, the points nearest to the border
 *   first, at most a sixth of the difference per pass (the bound of explicit diffusion
 *   in three dimensions). The sum of squared populations never rises.
 * - MoveRule::Field: where the point's value is below its cell's mean and above that of
 *   the cell across. No cell's mean ever falls: if the field is planarity, planar cells
 *   become purer and edges stand out.
 *
 * Means and tensors are sums of integers, so neither the order of the points nor the
 * number of threads changes a bit; means are exact to within 4e-6 of a cell for up to
 * 1e8 points.
 * \param[in] field a value per point, for MoveRule::Field; points without one (NaN)
 * stay
 * \throws std::invalid_argument see \ref validate; also for more than 2^40 cells, or
 * without a field where one is needed
 * \throws Canceled */
Clusters
clusterPoints(const Points& points,
              const ClusterSettings& settings,
              const std::vector<double>& field = {},
              ProgressMonitor* monitor = nullptr);

} // namespace linelet
