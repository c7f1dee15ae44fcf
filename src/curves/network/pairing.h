// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief Lengths that decide what belongs to a junction. */
struct PairingSettings {
  double cluster = 0;   ///< meetings closer than this are one junction
  double cut = 0;       ///< arms are cut back to this distance from the meetings
  double reach = 0;     ///< the direction of an arm is taken over this length
  double max_turn = 50; ///< degrees; a pair of arms that turns more is not joined
};

/** \brief Cuts curves where they meet and joins the arms again.
 *
 * Meetings are clustered into junctions; every curve is cut back around them. The arms
 * of a junction are paired greedily, the straightest pair first. If there are only two
 * arms, they are joined at any angle, at the point where their lines meet. Leftover
 * arms end at the nearest pair's connection, or at their common center if there is
 * none; \ref ModelCurve::junction is the number of the junction (>= 0). */
ModelCurves
pairArms(const ModelCurves& curves,
         const Points& meetings,
         const PairingSettings& settings);

} // namespace linelet
