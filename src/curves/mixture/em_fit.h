// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include <linelet/search/uniform_grid.h>

#include "banded_system.h"
#include "curves/ridges/model_curve.h"
#include "curves/ridges/scale_field.h"
#include "work_array.h"

namespace linelet {

/** \brief What the fit needs to know of a cloud beside its points. */
struct CloudFrame {
  double scale_unit = 0; ///< D, the median distance to the sixth neighbor
  double diagonal = 0;   ///< of the bounding box
  double volume = 0;     ///< (an area where the cloud is flat) that outliers fill
  int dimensions = 3;    ///< 2 where the points lie in a plane
};

/** \brief Measures \a points (finite, at least one) whose scale unit is \a scale_unit.
 */
CloudFrame
frameOf(const Points& points, double scale_unit);

/** \brief How a fit is run. */
struct EmSettings {
  double spacing = 0;         ///< of the nodes
  double noise = 0;           ///< standard deviation to begin with
  double least_noise = 0;     ///< the standard deviation never falls below this
  double bending = 1;         ///< q: variance of the direction per length, 1 / length
  double least_spacing = 0.7; ///< of the nodes, beside the standard deviation
  double fixed_radius =
      0; ///< radius of fixed-radius noise to begin with; 0: normal noise
  bool even_curvature = false;        ///< whether the curves are thought to bend evenly
  bool varied_noise = false;          ///< whether the noise varies along the curves
  const ScaleField* scales = nullptr; ///< by which spacing and noise grow from place to
                                      ///< place; null: nowhere
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
  double outlier_share = 0;  ///< of the points
  double log_likelihood = 0; ///< of the points under the mixture
  double freedom = 0;        ///< effective parameters of the curves' geometry
  /// Where the noise varies: -2 log of the prior density of its widths over their
  /// posterior one (Laplace), which the criterion adds as it adds parameters.
  double width_cost = 0;
  std::vector<double> outlier; ///< per point the probability that no curve made it
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

struct EdgePoints;
struct EdgeSums;
struct SortedArrays;
struct EdgeShape;
struct FixedRadiusMeans;

/** \brief Fits polylines to points by expectation maximization.
 *
 * The model: a point is uniform in the frame's volume with probability eps, else it
 * lies at a place of a curve, distributed with a density smooth along the curve, plus
 * normal noise, whose logarithm may vary along the curve as a random walk (its step is
 * estimated, too). The prior on a curve is a
 * Student distribution with 3 degrees of freedom of its second differences, whose scale
 * (q spacing^3) is estimated per curve over the posterior of the bends: smooth curves
 * stay round, corners survive. Its mean is none, or that of the bends around
 * (\ref EmSettings::even_curvature). Every few iterations open ends are grown by one
 * edge and cut back where the likelihood gains by it. One object fits one cloud many
 * times and keeps its memory. */
class EmFitter {
public:
  /** \param[in] points finite points; must outlive the fitter, as must \a grid
   * \param[in] grid the same points
   * \param[in] stop asked in every iteration; true: \ref fit throws Canceled */
  EmFitter(const Points& points,
           const UniformGrid& grid,
           const CloudFrame& frame,
           std::function<bool()> stop = {});

  /** \brief Fits \a curves, which give the topology and the start.
   * \param[in] rival score (\ref scoreOf) of the best model so far: what falls far
   * behind it is given up, and the fit is as it was then */
  EmFit
  fit(const ModelCurves& curves,
      const EmSettings& settings,
      double rival = std::numeric_limits<double>::infinity());

private:
  // Expectation maximization creeps where most of what a point says of a vertex is
  // unknown: the steps of the vertices and of the noise are made this much longer.
  static constexpr double stride = 1.5;

  struct Edge {
    Point from, direction;
    double length = 0;
    double scale = 1;             // by which everything is greater here
    double noise = 0;             // standard deviation here
    double paired_noise = 0;      // when its pairs were collected
    double weight = 0;            // probability of this edge in the mixture
    double share = 0, square = 0; // of the distances of its points, by shares
    std::size_t pairs_begin = 0, pairs_end = 0;
  };
  struct CurveState {
    ModelCurve curve;
    std::size_t first_edge = 0;
    double bending = 1, first_bending = 1;
    std::vector<double> bend_variance, bend_weight;
    Points bend_mean;                 // of the prior
    double mean_freedom = 0;          // effective parameters of these means
    std::vector<double> node_freedom; // effective parameters of each node
    // Per node the logarithm of the noise beside that of all (empty: the same), and the
    // variance of its change over the whole curve.
    std::vector<double> width;
    double width_change = 0;
  };

  bool
  trailsBehind(double rival, int iterations) const;
  /** \brief What the score of the fit depends on. */
  EmFit
  scored() const;
  EmFit
  result() const;
  void
  resampleCurves(double spacing, const ScaleField* scales);
  /** \brief The length of a curve, each edge beside its scale. */
  double
  scaledLength(const CurveState& state) const;
  void
  collectPairs();
  bool
  pairsAreStale() const;
  /** \brief Cuts back ends, and drops curves, whose points are explained as well
   * without them, by the information criterion.
   * \return whether anything changed */
  bool
  prune();
  std::size_t
  cheapestCut(const CurveState& state, int end, double penalty);
  void
  extendEnds(double spacing, const ScaleField* scales);
  void
  updateEdges();
  void
  expect();
  void
  densitiesOf(const Edge& edge);
  void
  fixedRadiusDensitiesOf(const Edge& edge);
  void
  measureInformation();
  EdgeSums
  fixedRadiusSumsOf(const Edge& edge, bool front, bool back);
  FixedRadiusMeans
  fixedRadiusMeansOf(const Edge& edge);
  void
  dropHollow(Edge& edge, double hollow);
  EdgeShape
  shapeOf(const Edge& edge) const;
  EdgePoints
  pointsOf(const Edge& edge) const;
  double
  kurtosis() const;
  void
  maximize(const EmSettings& settings);
  void
  measureNoise(const EmSettings& settings);
  void
  measureWidths(CurveState& state);
  double
  widthAt(const CurveState& state, std::size_t e) const;
  void
  measureFixedRadius(const EmSettings& settings);
  void
  maximizeCurve(CurveState& state, const EmSettings& settings);
  /** \brief Adds to the system what the points say of the nodes of a curve. */
  void
  pullTowardPoints(const CurveState& state);
  EdgeSums
  sumsOf(const Edge& edge, bool front, bool back);
  /** \brief Measures how a curve bends around each of its bends (\ref
   * EmSettings::even_curvature). */
  void
  measureEvenCurvature(CurveState& state, double spacing);
  /** \brief Adds to the system what the prior says of the bends of a curve. */
  void
  stiffen(CurveState& state, double spacing);
  /** \brief Solves the system, and measures how free each node is. */
  void
  moveNodes(CurveState& state);
  /** \brief Estimates how strongly a curve bends from its solved bends. */
  void
  measureBending(CurveState& state, double spacing);
  /** \brief What makes the square of bend \a i one at the scale 1. */
  double
  bendUnit(const CurveState& state, std::size_t i) const;
  /** \brief Variance of what is unknown of bend \a i, per coordinate. */
  double
  bendVariance(const ModelCurve& curve, std::size_t i) const;
  void
  updateWeights();

  const Points& points_;
  const UniformGrid& grid_;
  std::shared_ptr<const SortedArrays> sorted_; // of the grid
  CloudFrame frame_;
  std::function<bool()> stop_;

  std::vector<CurveState> states_;
  std::vector<Edge> edges_;
  // Pairs of an edge and a point near it, those of an edge together. The arrays end
  // with padding for vectors.
  WorkArray<Index> pair_index_;              // of the point, in the grid
  std::array<WorkArray<double>, 3> pair_at_; // coordinates of the point
  WorkArray<double> pair_density_;           // then responsibility
  // With fixed-radius noise: the place of the source on the edge, mean and mean square
  // of what its distance from the point differs from that length.
  WorkArray<double> pair_place_, pair_residual_, pair_spread_;
  std::vector<double> inlier_, residual_, information_; // per sorted index
  std::vector<double> removed_; // per point, the share that a cut takes away
  std::vector<double> density_; // per sorted index; after expect() its inverse
  std::vector<double> edge_count_;
  double fixed_radius_ = 0, noise_ = 0, outlier_share_ = 0, log_likelihood_ = 0,
         freedom_ = 0;
  double least_noise_ = 0, width_cost_ = 0;
  bool varied_ = false;           // the noise
  double square_ = 0, share_ = 0; // of the distances from the curves, by shares
  BandedSystem system_;
  Points solution_;
  std::vector<double> inverse_after_next_;
  std::vector<double> inverse_diagonal_, inverse_next_, data_diagonal_, data_next_;
};

} // namespace linelet
