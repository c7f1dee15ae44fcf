// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <limits>

#include <linelet/search/uniform_grid.h>

#include "e_step.h"
#include "em_model.h"
#include "free_ends.h"
#include "node_system.h"

namespace linelet {

/** \brief Fits polylines to points by expectation maximization.
 *
 * The model: a point is uniform in the frame's volume with probability eps; otherwise
 * its source lies on a curve, with a density that is smooth along the curve, and the
 * point is displaced from it by normal noise, the logarithm of whose deviation may vary
 * along the curve as a random walk (of estimated step). The prior on a curve is a
 * Student distribution with 3 degrees of freedom on its second differences, whose scale
 * (q spacing^3) is estimated per curve over the posterior of the bends: smooth curves
 * stay round, corners survive. Its mean is zero, or the mean of the neighboring bends
 * (\ref EmSettings::even_curvature). Every few iterations, open ends grow by one edge
 * and are cut back where that improves the likelihood, and curves may become straight
 * (\ref EmSettings::straight). One object fits one cloud many times and reuses its
 * memory. */
class EmFitter {
public:
  /** \param[in] points finite points; must outlive the fitter, as must \a grid
   * \param[in] grid the same points
   * \param[in] stop called in every iteration; if it returns true, \ref fit throws
   * Canceled */
  EmFitter(const Points& points,
           const UniformGrid& grid,
           const CloudFrame& frame,
           std::function<bool()> stop = {});

  /** \brief Fits \a curves, which give the topology and the initial geometry.
   * \param[in] rival score (\ref scoreOf) of the best model so far: a fit that falls
   * far behind it is abandoned and returned unfinished */
  EmFit
  fit(const ModelCurves& curves,
      const EmSettings& settings,
      double rival = std::numeric_limits<double>::infinity());

private:
  /** \brief Resamples the curves and finds their pairs. */
  void
  resampleCurves(const EmSettings& settings);
  void
  expect()
  {
    expectation_(mixture_, pairs_, fixed_radius_);
  }
  bool
  trailsBehind(double rival, int iterations) const;
  /** \brief The result, with all that its score depends on. */
  EmFit
  scored() const;
  EmFit
  result() const;

  const UniformGrid& grid_;
  MixtureState mixture_;
  EdgePairs pairs_;
  Expectation expectation_;
  FixedRadiusNoise fixed_radius_;
  NodeSystem system_;
  FreeEnds free_ends_;
  std::function<bool()> stop_;
};

} // namespace linelet
