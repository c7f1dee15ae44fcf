// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include <linelet/curves/curve_network.h>

#include "end_reach.h"

namespace linelet {

/** \brief The ends of the curves of a network, named 2 * curve + (0 front, 1 back). */
class CurveEnds {
public:
  /** \brief Both must outlive the object. */
  CurveEnds(const CurveNetwork& network, const EndReaches& reaches)
      : network_(network), reaches_(reaches)
  {
  }

  std::size_t
  size() const
  {
    return 2 * network_.curves.size();
  }
  const Curve&
  curveOf(std::size_t end) const
  {
    return network_.curves[end / 2];
  }
  const EndReach&
  reachOf(std::size_t end) const
  {
    return reaches_[end / 2][end % 2];
  }
  bool
  isOpen(std::size_t end) const
  {
    return !curveOf(end).closed && curveOf(end).points.size() > 1;
  }
  const Point&
  tip(std::size_t end) const
  {
    return vertex(end, 0);
  }
  /** \brief Unit vector that points out of the curve, over a last stretch as long as
   * the end's distance. */
  Point
  outward(std::size_t end) const;
  /** \brief Length of the curve from \a end to the nearer vertex of edge \a edge. */
  double
  arcTo(std::size_t end, std::size_t edge) const;
  /** \brief Whether two ends are close enough and do not run side by side. */
  bool
  meet(std::size_t end, std::size_t other) const;

private:
  const Point&
  vertex(std::size_t end, std::size_t steps) const
  {
    const Points& points = curveOf(end).points;
    return points[end % 2 == 0 ? steps : points.size() - 1 - steps];
  }

  const CurveNetwork& network_;
  const EndReaches& reaches_;
};

/** \brief A place inside a curve, on the edge that begins at vertex \a edge. */
struct Place {
  static constexpr auto none = std::numeric_limits<std::size_t>::max();

  std::size_t curve = none, edge = 0;
  double along = 0; ///< of the edge, 0 to 1
  Point position = Point::Zero();
};

/** \brief Ends that meet, and the places inside curves that they meet. */
struct Meeting {
  std::vector<std::size_t> ends;
  std::vector<Place> places;
};

/** \brief All meetings of open ends of \a network (\ref connectEnds). */
std::vector<Meeting>
findMeetings(const CurveNetwork& network, const EndReaches& reaches);

} // namespace linelet
