// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Properties of a whole cloud, so that each of its parts gives the same curves
 * as the whole. */
struct CloudTraits {
  double scale_unit = 0;      ///< D, unit of the points
  double linear_share = 0;    ///< share of the points with a linear neighborhood
  double points = 0;          ///< number of points; 0: the traits are unknown
  Point low = Point::Zero();  ///< corners of the box around them
  Point high = Point::Zero(); ///< likewise
};

/** \brief Settings of the refined reconstruction; 0: chosen automatically. */
struct RefinedSettings {
  /// Steps per trace from its start point; 0: limited only by the number of points
  unsigned max_iterations = 0;
  /// Traces started per connected component of the cloud; 0: until every point that
  /// looks like a curve is explained
  unsigned start_points = 0;
  /// No gap wider than this is bridged, in the unit of the points, and points closer
  /// together than this form one connected component; 0: no limit, and 5 D. Where
  /// directions agree, gaps of up to 2.5 D or 15 % of the joined length are bridged; in
  /// a scene, hidden stretches of up to 150 point spacings.
  double distance_cutoff = 0;
  bool only_stiff = false; ///< in a scene, leave out curves that turn more than a few
                           ///< degrees over ten of their points
  bool may_be_straight = true; ///< in a cloud of curves alone, try straight curves;
                               ///< off where all sag, as wires do
  unsigned threads = 0;        ///< 0: all
  CloudTraits whole;           ///< traits of the cloud, if known
};

} // namespace linelet
