// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <vector>

#include "curves/ridges/model_curve.h"
#include "curves/ridges/scale_field.h"

namespace linelet {

/** \brief How a fit is run. */
struct EmSettings {
  double spacing = 0;         ///< of the nodes
  double noise = 0;           ///< initial standard deviation
  double least_noise = 0;     ///< lower bound of the standard deviation
  double bending = 1;         ///< q: variance of the direction per length, 1 / length
  double least_spacing = 0.7; ///< of the nodes, in standard deviations
  double outlier_share = 0.1; ///< of the points, initially
  double most_outliers = 1;   ///< of the points, at most: what the background allows
  double fixed_radius = 0;    ///< initial radius of fixed-radius noise; 0: normal noise
  bool even_curvature = false; ///< whether curves are assumed to bend evenly
  bool varied_noise = false;   ///< whether the noise varies along the curves
  bool straight = false;       ///< whether curves may become straight (\ref straighten)
  /// Local factor of spacing and noise; null: 1 everywhere
  const ScaleField* scales = nullptr;
  int iterations = 15;
  int resample_every = 5;
};

/** \brief A fitted model of a cloud. */
struct EmFit {
  ModelCurves curves;
  double noise = 0;        ///< standard deviation per coordinate
  double fixed_radius = 0; ///< radius of the noise; 0: normal noise
  /// Fourth moment of the distances of the points from the curves over the square of
  /// the second: 2 for normal noise (3 in a plane), 1.2 for fixed-radius noise.
  double kurtosis = 0;
  /// Root mean square of the distances of the points from the curves, per coordinate
  /// across them: as measured, whereas the noise above has a lower bound.
  double spread = 0;
  double outlier_share = 0;  ///< of the points
  double log_likelihood = 0; ///< of the points under the mixture
  double freedom = 0;        ///< effective parameters of the curves' geometry
  double evidence = 0;       ///< half of the criterion's gain over no curve, if known
  /// If the noise varies: -2 log of the prior density of its widths over their
  /// posterior density (Laplace), which the criterion adds just as it adds parameters.
  double width_cost = 0;
  std::vector<double> outlier;             ///< probability that a point is an outlier
  std::vector<std::vector<double>> counts; ///< points explained by each edge

  /** \brief Root mean square of the distances of points from their sources, per
   * coordinate. */
  double
  deviation() const
  {
    return fixed_radius > 0
               ? std::sqrt((fixed_radius * fixed_radius + noise * noise) / 3)
               : noise;
  }
  /// Standard deviation at each node of each curve, or empty where it does not vary.
  std::vector<std::vector<double>> noises;
};

} // namespace linelet
