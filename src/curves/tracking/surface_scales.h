// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <linelet/features/multi_scale_types.h>
#include <linelet/search/uniform_grid.h>

namespace linelet {

inline constexpr double largest_radius = 17; ///< D, of the balls that are looked at
/// \name Linearity and neighbors from which on a ball is linear
/// @{
inline constexpr double linear_ball = 0.75;
inline constexpr std::uint32_t least_linear = 5;
/// @}

/** \brief What the multi-scale shape of a point says about a surface through it. */
struct SurfaceScales {
  bool any = false;
  double radius = 0;   ///< the smallest scale at which the neighborhood is one
  double density = 0;  ///< points per area there
  bool linear = false; ///< whether a smaller or a larger scale is linear
  bool hardly = false; ///< whether a smaller one is at least weakly so

  /** \brief Whether the shape alone cannot decide between scan lines and curves side by
   * side. */
  bool
  isDoubtful() const
  {
    return any && (linear || hardly);
  }
};

/** \brief Scales at which the neighborhood is planar and grows like a surface, three of
 * them in a row.
 * \param[in] graph shapes about the point itself
 * \param[in] radii of \a graph */
SurfaceScales
surfaceScales(const ShapeGraph& graph, const std::vector<double>& radii);

/** \brief Distance within which \ref isSurface looks at the points. */
double
reachOf(const SurfaceScales& scales);

/** \brief Whether a surface runs through \a p, rather than a few lines side by side.
 * \param[in] grid of all points within \ref reachOf
 * \param[in] scales those of \a p */
bool
isSurface(const UniformGrid& grid, const Point& p, const SurfaceScales& scales);

} // namespace linelet
