// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <linelet/search/uniform_grid.h>

namespace linelet {

/** \brief Coordinates of the points of a grid by sorted index, one array per axis; each
 * has room for \ref padding elements more than there are points. */
struct SortedArrays {
  static constexpr std::size_t padding = 16; ///< at least the lanes of any vector

  explicit SortedArrays(const UniformGrid& grid)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      axis[k].reserve(grid.size() + padding);
      for (const Point& p : grid.sortedPoints())
        axis[k].push_back(p[static_cast<Eigen::Index>(k)]);
      axis[k].resize(grid.size() + padding, 0);
    }
  }

  std::array<std::vector<double>, 3> axis;
};

/** \brief Sorted indices from begin to end. */
struct SortedRun {
  std::size_t begin, end;
};

/** \brief Sums over points of w, w v and w v v^T, v their offset from a query. */
struct FieldSums {
  double weight;
  double first[3];
  double second[6]; ///< xx xy xz yy yz zz
};

/** \brief The points within some distance of an edge, consecutively. */
struct NearEdge {
  double from[3];
  double direction[3]; ///< unit vector
  double length;
  double reach;
};

/** \brief Inner loops over runs of sorted indices, for the instruction set of the
 * machine that runs them. */
struct SortedKernels {
  /** \brief Sums with w = (1 - d^2 / radius^2)^4 within \a radius of \a query. */
  void (*fieldSums)(const SortedArrays& points,
                    const std::vector<SortedRun>& runs,
                    const double* query,
                    double radius,
                    FieldSums& sums);

  /** \brief Writes the sorted indices and the coordinates of the points near \a edge to
   * arrays with room for all points of the runs and \ref SortedArrays::padding more.
   * \return their number */
  std::size_t (*nearEdge)(const SortedArrays& points,
                          const std::vector<SortedRun>& runs,
                          const NearEdge& edge,
                          Index* sorted_indices,
                          const std::array<double*, 3>& at);
};

/** \brief The kernels for this machine. */
const SortedKernels&
sortedKernels();

} // namespace linelet
