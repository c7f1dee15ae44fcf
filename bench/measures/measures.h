// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/curves/curve_network.h>

namespace linelet::bench {

/** \brief Scales of the measures, in the unit of the curves. The defaults suit the test
 * geometries, whose extent is about 10. */
struct MeasureSettings {
  double step = 0.05;              ///< spacing of the samples on both curves
  double reach = 0.5;              ///< vertices farther from the truth cover nothing
  double max_mean_distance = 0.25; ///< largest E_V of a success
};

template <class Visit>
void
describe(MeasureSettings& settings, Visit&& visit)
{
  visit("step", settings.step, "spacing of the samples on both curves");
  visit("reach",
        settings.reach,
        "vertices farther than this from the truth cover nothing");
  visit("max-mean-distance", settings.max_mean_distance, "largest E_V of a success");
}

/** \brief How far a reconstruction is from the truth (Ritter, Schiffner, Harders 2021,
 * section 6.3). */
struct Measures {
  /// Hausdorff distance: the larger of the two directed maxima; NaN for no
  /// reconstruction.
  double e_h = 0;
  /// Mean distance of the samples of each curve to the other; NaN for no
  /// reconstruction.
  double e_v = 0;
  /// Length of the reconstruction / length of the truth.
  double e_len = 0;
  /// Share of the truth's length that edges of the reconstruction cover, in [0, 1].
  double e_com = 0;
  /// E_Len in [0.9, 1.2], E_Com in [0.95, 1.05], E_V at most 0.25.
  bool success = false;
};

/** \brief Compares \a reconstruction with \a truth.
 *
 * Both are sampled evenly, curve by curve, at most `step` apart (farther where a curve
 * would need more than two million samples); distances to the other's edges are exact.
 * An edge of the reconstruction covers the arc of the truth between the projections of
 * its two vertices (the shorter one on a closed curve) if both lie within `reach` of
 * the truth and project on the same curve of it.
 * \throws std::invalid_argument if the truth has no length or a vertex is not finite */
Measures
measure(const CurveNetwork& reconstruction,
        const CurveNetwork& truth,
        const MeasureSettings& settings = {});

} // namespace linelet::bench
