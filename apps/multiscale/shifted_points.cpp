// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "shifted_points.h"

#include <cmath>

#include <linelet/search/grid_search.h>

#include "scale_cost.h"

namespace linelet::apps {

namespace {

/** \brief Announces how long a long shift will take, measured on a few points. */
void
announceShift(const Points& points, const CentroidShiftSettings& shift, Frame& frame)
{
  if (!(shift.radius > 0 && std::isfinite(shift.radius)))
    return; // the caller rejects it
  const GridSearch search(points, shift.radius);
  const ScaleCost cost = measuredCost(points, 160, [&](const Indices& chosen) {
    Points some;
    for (const Index i : chosen)
      some.push_back(points[i]);
    shiftToCentroids(search, some, shift, &frame.monitor);
    double neighbors = 0;
    Indices found;
    for (const Point& p : some) {
      search.within(p, shift.radius, found);
      neighbors += static_cast<double>(found.size());
    }
    return neighbors;
  });
  announce(cost, points.size(), "centroid shift", "--centroid-shift", frame);
}

} // namespace

Points
shiftedPoints(io::Cloud& cloud,
              const io::UsablePoints& usable,
              const CentroidShiftSettings& shift,
              Frame& frame)
{
  if (shift.radius == 0)
    return usable.points();
  announceShift(usable.points(), shift, frame);
  Points points = shiftToCentroids(usable.points(), shift, &frame.monitor);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      cloud.points[i] = points[i];
  return points;
}

} // namespace linelet::apps
