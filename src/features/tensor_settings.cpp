// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/tensor_settings.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include <linelet/support/text.h>

namespace linelet {

void
validate(const TensorSettings& settings,
         const NeighborhoodSizes& sizes,
         std::size_t queries)
{
  checkWeightings(settings.centroid, settings.weighting, settings.centroid_weighting);
  const int said = (settings.radius != 0) + (settings.k != 0) + !sizes.radii.empty() +
                   !sizes.counts.empty();
  if (said == 0 && queries > 0)
    throw std::invalid_argument(
        "no size of neighborhood is given: set a radius, or the "
        "number k of nearest points");
  if (said > 1)
    throw std::invalid_argument("more than one size of neighborhood is given: set "
                                "either one radius, or one k, or sizes point by point");
  if (settings.radius != 0 && !isRadius(settings.radius))
    throw std::invalid_argument("radius " + textOf(settings.radius) +
                                " is not a positive finite number");
  const std::size_t given = std::max(sizes.radii.size(), sizes.counts.size());
  if (given != 0 && given != queries)
    throw std::invalid_argument(std::to_string(given) +
                                " sizes of neighborhoods are given for " +
                                std::to_string(queries) + " points");
}

} // namespace linelet
