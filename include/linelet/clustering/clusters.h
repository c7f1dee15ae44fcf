// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <linelet/support/face.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/neighborhood_tensor.h>

namespace LINELET_PUBLIC linelet {

/** \brief What represents the members of a cell. */
struct Representative {
  Point center;                       ///< their mean
  SymmetricTensor tensor;             ///< their covariance
  Index count = 0;                    ///< their number
  std::array<std::int32_t, 3> cell{}; ///< where the cell lies in the grid
};

/** \brief Points grouped by the cells of a curvilinear grid. */
struct Clusters {
  static constexpr Index none = std::numeric_limits<Index>::max();

  std::vector<Representative> representatives; ///< each has members
  Indices cluster_of; ///< representative of every point; \ref none if it is not finite
                      ///< or out of the camera's view
  std::array<std::int64_t, 3> cells{}; ///< of the grid, along each of its axes
  double leaf = 0; ///< edge of the cells where they are cubes, else 0
  Points normals;  ///< of the representatives; NormalRule::EmptyCells only
  /// As ClusterSettings::faces says. Representatives without a plane (fewer than three
  /// members, or collinear members where normals are along the smallest extent) have no
  /// quad.
  std::vector<Face> faces;
};

/** \brief The mean of \a values over the members of every representative, ignoring NaN.
 */
std::vector<double>
clusterMeans(const Clusters& clusters, const std::vector<double>& values);

/** \brief The most frequent of \a values among the members of every representative, the
 * smallest in a tie: for classes and other labels. */
std::vector<double>
clusterModes(const Clusters& clusters, const std::vector<double>& values);

} // namespace linelet
