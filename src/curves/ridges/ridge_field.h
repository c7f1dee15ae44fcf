// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include <linelet/search/uniform_grid.h>
#include <linelet/support/points.h>

#include "scale_field.h"

namespace linelet {

struct SortedArrays;

/** \brief Density of a cloud smoothed with bandwidth b, whose ridges are curves.
 *
 * The kernel is (1 - d^2 / (3b)^2)^4, close to exp(-d^2 / 2b^2) and zero from 3b on.
 * Points of low support (outliers) are left out of the density. */
class RidgeField {
public:
  /** \param[in] points finite points
   * \param[in] bandwidth b > 0
   * \param[in] scales local factor of b; null: 1 everywhere. It must outlive the field
   */
  RidgeField(const Points& points,
             double bandwidth,
             const ScaleField* scales = nullptr);

  /** \brief The density around one place. */
  struct Sample {
    double support = 0;         ///< sum of weights; 0: nothing within 3b
    Point mean = Point::Zero(); ///< weighted mean of the points
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< about the mean
  };

  Sample
  sample(const Point& x) const;

  /** \brief Start point candidates: indices into the points given, best score first.
   * The score is support * (0.2 + linearity). */
  const Indices&
  seeds() const
  {
    return seeds_;
  }

  /** \brief Support of each point given; 0 for those left out. */
  const std::vector<double>&
  supports() const
  {
    return supports_;
  }
  double
  medianSupport() const
  {
    return median_support_;
  }
  double
  bandwidthAt(const Point& x) const
  {
    return scales_ ? bandwidth_ * scales_->at(x) : bandwidth_;
  }
  double
  widestBandwidth() const
  {
    return scales_ ? bandwidth_ * scales_->widest() : bandwidth_;
  }
  const UniformGrid&
  grid() const
  {
    return grid_;
  }
  /** \brief The points that \ref grid finds. */
  const Points&
  kept() const
  {
    return kept_;
  }
  /** \brief For each kept point its index among the points given. */
  const Indices&
  keptIndices() const
  {
    return kept_indices_;
  }

private:
  double bandwidth_;
  const ScaleField* scales_;
  std::vector<double> supports_;
  double median_support_ = 0;
  Points kept_;
  Indices kept_indices_;
  UniformGrid grid_;
  std::shared_ptr<const SortedArrays> sorted_; // of the grid
  Indices seeds_;
};

} // namespace linelet
