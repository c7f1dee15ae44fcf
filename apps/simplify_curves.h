// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

#include <linelet/curves/curve_network.h>
#include <linelet/support/points.h>

namespace linelet::apps {

/** \brief How far vertices may be moved off curves to have fewer: a length, or "auto",
 * a tenth of the noise of the points about the curves. */
class SimplifyTolerance {
public:
  /** \throws std::invalid_argument unless "auto" or a number >= 0 */
  explicit SimplifyTolerance(std::string_view text);

  const std::string&
  name() const
  {
    return text_;
  }

  /** \brief The length, for curves of \a network through \a points; 0: as they are. */
  double
  length(const CurveNetwork& network, const Points& points) const;

private:
  std::string text_;
  double length_ = -1; // negative: by the noise
};

/** \brief Standard deviation, along each axis across a curve, of \a points about the
 * curves of \a network; 0 where there are none of either. From the median distance,
 * which points of no curve hardly change. */
double
noiseAbout(const CurveNetwork& network, const Points& points);

/** \brief The curves with the fewest of their vertices that Douglas and Peucker's
 * algorithm leaves within \a tolerance of them (Cartographica 10, 1973). Ends and
 * places where curves meet stay. */
CurveNetwork
simplified(CurveNetwork network, double tolerance);

} // namespace linelet::apps
