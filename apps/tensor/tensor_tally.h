// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "neighbor_finder.h"
#include "size_fields.h"

namespace linelet::apps {

/** \brief Totals over the records of a cloud. */
struct Tally {
  std::size_t points = 0;
  std::size_t left_out = 0;  ///< unused ones
  std::size_t unknown = 0;   ///< others that have no shape
  double mean_neighbors = 0; ///< over the others

  void
  add(const Tally& more)
  {
    const auto before = static_cast<double>(points - left_out);
    const auto behind = static_cast<double>(more.points - more.left_out);
    if (before + behind > 0)
      mean_neighbors =
          (mean_neighbors * before + more.mean_neighbors * behind) / (before + behind);
    points += more.points;
    left_out += more.left_out;
    unknown += more.unknown;
  }
};

Tally
tallyOf(const std::vector<PointDistributionTensor>& records, std::size_t left_out);

/** \brief Reports the totals for \a file. */
void
print(const Tally& tally,
      const std::string& file,
      const TensorSettings& settings,
      const NeighborFinder& finder,
      const SizeFields& fields);

/** \brief Reports how many points have no shape. */
void
printUnknown(const Tally& tally);

/** \brief The same; if they are many, also suggests a radius that would give them one.
 * \param[in] scale_unit of \a points; NaN: not known yet */
void
printUnknown(const Tally& tally, double scale_unit, const Points& points);

void
summarize(nlohmann::ordered_json& summary,
          const Tally& tally,
          const TensorSettings& settings,
          const NeighborFinder& finder,
          const SizeFields& fields);

} // namespace linelet::apps
