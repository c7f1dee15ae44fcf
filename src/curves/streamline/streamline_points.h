// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>

#include <linelet/curves/streamline_settings.h>
#include <linelet/search/subset_search.h>

#include "cloud_neighbors.h"

namespace linelet {

/** \brief The points that line-lets follow, their neighbor search, and their scale. */
class StreamlinePoints {
public:
  /** \brief The finite points of \a all; without duplicates if more than half of them
   * coincide with others, so that they have a scale.
   * \param[in] search over \a all, or null */
  StreamlinePoints(const Points& all,
                   const NeighborSearch* search,
                   const StreamlineSettings& settings);
  StreamlinePoints(const StreamlinePoints&) = delete;
  StreamlinePoints&
  operator=(const StreamlinePoints&) = delete;

  /** \brief The index among \ref points of the point with \a index among all.
   * \throws std::invalid_argument if it is not one of them */
  Index
  placeOf(Index index, std::size_t all) const;

  /** \brief The indices among all points of \ref points. */
  const Indices&
  chosen() const
  {
    return chosen_;
  }

  Points points;
  double scale_unit = 0; ///< D; if it is not positive, there are no neighbors
  std::optional<CloudNeighbors> neighbors;

private:
  void
  choose(const Points& all, const Indices& chosen);
  void
  measure(const StreamlineSettings& settings);

  const NeighborSearch* search_;
  Indices chosen_; // of all points
  std::optional<SubsetSearch> subset_;
};

} // namespace linelet
