// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <bench/geometries/geometries.h>
#include <linelet/curves/curve_network.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::bench {

/** \brief How a test geometry is sampled and disturbed (Ritter, Schiffner, Harders
 * 2021, section 6.1). Lengths are in the unit of the geometry, whose extent is about
 * 10. */
struct SamplingSettings {
  std::size_t points = 256; ///< N: samples along the curves, before holes and outliers
  double distribution = 0;  ///< S_D in [0, 1]: 0 even along the arc, 1 uniformly random
  double jitter = 0;        ///< S_J: distance by which every sample is displaced
  std::size_t outliers = 0; ///< M: points spread evenly over the enlarged bounding box
  std::array<double, 2> hole = {0, 0}; ///< samples with t in [A, B] of [0, 1] are left
                                       ///< out; A = B: none
  double out_of_plane = 0; ///< S_O: the curve is bent out of its plane by this much
  std::uint64_t seed = 1;  ///< of all random draws
};

template <class Visit>
void
describe(SamplingSettings& settings, Visit&& visit)
{
  visit("points", settings.points, "samples along the curves");
  visit("distribution",
        settings.distribution,
        "0 even along the arc, 1 uniformly random, or between");
  visit("jitter", settings.jitter, "distance by which every sample is displaced");
  visit("outliers", settings.outliers, "random points added in the bounding box");
  visit("out-of-plane",
        settings.out_of_plane,
        "how far the curve is bent out of its plane");
  visit("seed", settings.seed, "the same seed gives the same cloud");
}

/** \brief Noisy samples of \a geometry: those of the curves in arc order, then the
 * outliers.
 *
 * With t_i = i / N over the arc of all components, r_i sorted and uniform, sample i
 * lies at (1 - S_D) t_i + S_D r_i, displaced by S_J times the unit vector of three
 * uniforms of
 * [-1, 1]. The box of the outliers is that of the samples, enlarged by 10 % of its
 * diagonal on each side (in a direction in which it is flat only if S_J > 0). The same
 * settings give the same points on every machine.
 * \throws std::invalid_argument for settings out of range; Canceled */
Points
sample(Geometry geometry,
       const SamplingSettings& settings,
       const ProgressMonitor* monitor = nullptr);

/** \brief The same for any curves, which are not bent: out_of_plane is ignored. */
Points
sample(const CurveNetwork& network,
       const SamplingSettings& settings,
       const ProgressMonitor* monitor = nullptr);

} // namespace linelet::bench
