// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <linelet/features/multi_scale_types.h>
#include <linelet/support/points.h>

namespace linelet {

/** \brief Start points of line-lets by the score O_s = d N1^a (CL_max A)^4 (Ritter,
 * Schiffner, Harders 2021, equation 7), d the distance to the nearest start point. */
class StartPoints {
public:
  /** \param[in] points kept by reference
   * \param[in] shapes features of \a points
   * \param[in] min_neighbors N1 that a start point needs; 2 if no point has that many
   * \param[in] neighbor_exponent a, as published 0.01
   * \param[in] among the points to consider */
  StartPoints(const Points& points,
              const std::vector<MultiScaleShape>& shapes,
              unsigned min_neighbors,
              double neighbor_exponent,
              const Indices& among);

  /** \brief The same among all points. */
  StartPoints(const Points& points,
              const std::vector<MultiScaleShape>& shapes,
              unsigned min_neighbors,
              double neighbor_exponent = 0.01);

  /** \brief Takes the point with the best score; later scores include the distance to
   * it. For the first, d is 1. No point is taken twice.
   * \param[in] least the score must exceed this
   * \return its index, or none (see \ref none) if no candidate is left */
  Index
  next(double least = 0);

  /** \brief The score of the last \ref next that was not none. */
  double
  lastScore() const
  {
    return last_score_;
  }

  /** \brief Up to \a count candidates for which \a wanted holds, best score without d
   * first, no two closer than \a spacing. They are taken. */
  Indices
  spread(std::size_t count, double spacing, const std::function<bool(Index)>& wanted);

  static constexpr Index none = static_cast<Index>(-1);

private:
  void
  take(Index point);

  const Points& points_;
  Indices candidates_;          // by score without d, best first
  std::vector<double> score_;   // of each candidate, without d
  std::vector<double> squared_; // of each candidate: distance to the nearest start
  double last_score_ = 0;
  bool any_ = false;
};

} // namespace linelet
