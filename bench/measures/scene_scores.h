// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <bench/scenes/scene.h>
#include <linelet/curves/curve_network.h>

namespace linelet::bench {

/** \brief What counts as correct in a scene. Lengths in meters. */
struct SceneScoreSettings {
  double step = 0.5;    ///< spacing of samples
  double near = 0.10;   ///< a true wire is covered where something found is this near,
  double noises = 3;    ///< ... or within this many standard deviations of its points,
  double margin = 0.10; ///< ... or this near to its bundle
  double astray = 0.50; ///< a found wire is false if no wire (bundle) is this near
  double beside = 0.25; ///< a found curve is false where nothing long and thin (its
                        ///< surface, its bundle) is this near
};

/** \brief Lengths in meters; sums over scenes. */
struct SceneScores {
  double true_length = 0;
  double covered_length = 0; ///< of the true wires
  double found_length = 0;
  double right_length = 0; ///< of what was found

  /** \brief NaN where there is no wire. */
  double
  recall() const;
  /** \brief NaN if nothing was found. */
  double
  precision() const;
  double
  falseLength() const
  {
    return found_length - right_length;
  }

  SceneScores&
  operator+=(const SceneScores& other);
};

/** \brief Compares wires with the truth. A true wire is covered within max(near, noises
 * x its noise, bundle radius + margin) of a vector. A vector is correct within astray
 * of a wire's bundle or of a jumper loop.
 * \param[in] found in the frame of \a truth */
SceneScores
scoreSceneWires(const CurveNetwork& found,
                const SceneScan& truth,
                const SceneScoreSettings& settings = {});

/** \brief Compares curves with the truth. A true wire is covered within max(near,
 * bundle radius + margin) of a curve. A curve is correct within \a beside of anything
 * long and thin: wire, pole, lattice, jib, pipe, railing, guy, rail, trunk, branch.
 * \param[in] found in the frame of \a truth */
SceneScores
scoreSceneCurves(const CurveNetwork& found,
                 const SceneScan& truth,
                 const SceneScoreSettings& settings = {});

/** \brief Wires of about the same stated confidence. */
struct CalibrationBin {
  double from = 0, to = 1; ///< of the confidence
  std::size_t wires = 0;
  std::size_t right = 0; ///< more than half of them on a true wire
  double confidence_sum = 0;
};

/** \brief Bins found wires by their stated confidence.
 * \param[in] found one curve per wire, in the frame of \a truth
 * \param[in] confidence one per wire, in [0, 1]
 * \param[in,out] bins results are added to them
 * \throws std::invalid_argument for vectors of different lengths */
void
calibrate(const CurveNetwork& found,
          const std::vector<double>& confidence,
          const SceneScan& truth,
          std::vector<CalibrationBin>& bins,
          const SceneScoreSettings& settings = {});

} // namespace linelet::bench
