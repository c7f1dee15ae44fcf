// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>

#include <linelet/features/multi_scale.h>

#include "frame.h"

namespace linelet::apps {

/** \brief The cost of the shapes of a cloud's neighborhoods. */
struct ScaleCost {
  double neighbors = 0; ///< points within the largest radius, on average
  double seconds = 0;   ///< wall time for all queries
};

/** \brief The cost of \a work on \a queries, measured on a few of them: first on so few
 * that it takes hardly any time, then on more until it does.
 * \param[in] most queries worth a try
 * \param[in] work on the given indices of queries; returns their total number of
 * neighbors */
ScaleCost
measuredCost(const Points& queries,
             std::size_t most,
             const std::function<double(const Indices& chosen)>& work);

/** \brief Announces how long slow work will take, and why.
 * \param[in] size as text: "largest radius 5"
 * \param[in] option that makes it shorter */
void
announce(const ScaleCost& cost,
         std::size_t queries,
         const std::string& size,
         const char* option,
         const Frame& frame);

/** \brief The same for the multi-scale shapes of \a queries among \a points, measured.
 * \param[in] settings with the radii and the engine that will be used */
void
announceMultiScale(const Points& points,
                   const Points& queries,
                   const MultiScaleSettings& settings,
                   Frame& frame);

} // namespace linelet::apps
