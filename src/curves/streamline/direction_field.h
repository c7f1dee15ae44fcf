// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <Eigen/Core>

#include <linelet/curves/streamline_settings.h>
#include <linelet/features/multi_scale_types.h>
#include <linelet/support/points.h>
#include <linelet/tensor/neighborhood_tensor.h>

#include "cloud_neighbors.h"

namespace linelet {

/** \brief What determines the direction of a step at one position. */
struct LocalScale {
  double radius = 0;                    ///< of the neighborhood
  double blend = 0;                     ///< mu: share of the eigenvector
  double optimal_radius = 0;            ///< of the nearest point; 0: unknown
  Index nearest = CloudNeighbors::none; ///< that point
};

/** \brief Directions in which curves continue, at any position near the points (Ritter,
 * Schiffner, Harders 2021, equations 4, 5 and 8). Queries are thread-safe. */
class DirectionField {
public:
  /** \param[in] points with finite coordinates; kept by reference, like \a neighbors
   * \param[in] shapes their multi-scale features
   * \param[in] neighbors among the same points
   * \param[in] tensors of the points, if given; empty: those at the optimal scales, for
   * the modes that need them */
  DirectionField(const Points& points,
                 const MultiScaleShapes& shapes,
                 const CloudNeighbors& neighbors,
                 const StreamlineSettings& settings,
                 const std::vector<SymmetricTensor>& tensors = {});

  /** \brief Radius and blend of the point nearest to \a position; \a last if none is
   * within the search radius, or if the nearest has no optimal scale. */
  LocalScale
  scaleAt(const Point& position, const LocalScale& last) const;

  /** \brief The unit direction at \a position of a curve that arrives along \a last (a
   * unit vector); \a last itself if no point gives a direction. */
  Point
  at(const Point& position, const Point& last, const LocalScale& scale) const;

  /** \brief The optimal eigenvector e3 of point \a i; NaN if it has none. */
  Point
  eigenvector(Index i) const
  {
    return eigenvectors_[i];
  }

  double
  scaleUnit() const
  {
    return scale_unit_;
  }

private:
  /** \brief e3 of the place itself at one radius; zero if it has none. */
  Point
  computedEigenvector(const Point& position, const Point& last, double radius) const;

  /** \brief e3 of the place itself at its own optimal scale, and its blend. */
  Point
  multiScaleEigenvector(const Point& position, const Point& last, double& blend) const;

  Point
  interpolatedEigenvector(const Point& position,
                          const Point& last,
                          double radius) const;
  Point
  angular(const Point& position,
          const Point& last,
          double radius,
          bool with_distance) const;
  Eigen::Matrix3d
  interpolatedTensor(const Point& position, double radius) const;

  const Points& points_;
  const CloudNeighbors& neighbors_;
  const StreamlineSettings& settings_;
  double scale_unit_;
  std::vector<double> radii_;            // of the scales
  Points eigenvectors_;                  // NaN: none
  std::vector<LocalScale> scales_;       // radius 0: none
  std::vector<SymmetricTensor> tensors_; // of trace 1; only for the modes that use them
};

} // namespace linelet
