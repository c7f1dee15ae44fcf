// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "cloud_frame.h"
#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief Over-relaxation: expectation maximization converges slowly where points carry
 * little information about a vertex, so steps of vertices and noise are lengthened by
 * this factor. */
constexpr double stride = 1.5;

/** \brief An edge of a curve, a component of the mixture. */
struct MixtureEdge {
  Point from, direction;
  double length = 0;
  double scale = 1;             ///< local factor of all lengths
  double noise = 0;             ///< standard deviation here
  double paired_noise = 0;      ///< when its pairs were collected
  double weight = 0;            ///< probability of this edge in the mixture
  double share = 0, square = 0; ///< of the distances of its points, by shares
  std::size_t pairs_begin = 0, pairs_end = 0;
};

/** \brief A curve while it is fitted. */
struct MixtureCurve {
  ModelCurve curve;
  std::size_t first_edge = 0;
  double bending = 1, first_bending = 1;
  bool straight = false; ///< \ref straighten
  std::vector<double> bend_variance, bend_weight;
  Points bend_mean;                 ///< of the prior
  double mean_freedom = 0;          ///< effective parameters of these means
  std::vector<double> node_freedom; ///< effective parameters of each node
  /// Per node, the logarithm of the noise relative to the overall one (empty: 0), and
  /// the variance of its change over the whole curve.
  std::vector<double> width;
  double width_change = 0;
};

/** \brief The noise of a mixture, and the sums it is estimated from. */
struct MixtureNoise {
  double deviation = 0;         ///< standard deviation
  double fixed_radius = 0;      ///< 0: normal noise
  double least = 0;             ///< lower bound of the standard deviation
  bool varied = false;          ///< along the curves
  double square = 0, share = 0; ///< of the distances from the curves, by shares
  double width_cost = 0;        ///< see EmFit::width_cost
};

/** \brief A mixture of noisy edges and uniform outliers while it is fitted. */
struct MixtureState {
  CloudFrame frame;
  std::size_t points = 0; ///< their number
  std::vector<MixtureCurve> curves;
  std::vector<MixtureEdge> edges; ///< of all curves, one after the other
  std::vector<double> edge_count; ///< points explained by each
  MixtureNoise noise;
  double outlier_share = 0, most_outliers = 1; ///< shares of the points
  double log_likelihood = 0, freedom = 0;

  /** \brief \a share of outliers, at most \ref most_outliers and away from 0 and 1. */
  double
  boundedShare(double share) const
  {
    return std::clamp(share, 1e-3, std::clamp(most_outliers, 1e-3, 1 - 1e-3));
  }

  /** \brief The length of a curve, each edge relative to its scale. */
  double
  scaledLength(const MixtureCurve& state) const;

  /** \brief Recomputes the edges from the nodes and the noise. */
  void
  updateEdges();
};

/** \brief The logarithm of the noise of edge \a e relative to the overall one. */
double
widthAt(const MixtureCurve& state, std::size_t e);

} // namespace linelet
