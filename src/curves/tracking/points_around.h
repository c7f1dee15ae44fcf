// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <utility>
#include <vector>

#include "surroundings.h"

namespace linelet {

/** \brief The points near a curve that no other one explains. */
class PointsAround {
public:
  /** \param[in] distance from \a curve, at most */
  PointsAround(const TrackedScene& scene, const ModelCurve& curve, double distance);

  /** \brief Those within \a distance, in ascending order. */
  Indices
  within(double distance) const;

  /** \brief Number of those between two distances. */
  double
  count(double from, double to) const;

private:
  std::vector<std::pair<Index, double>> points_; ///< and their squared distances
};

} // namespace linelet
