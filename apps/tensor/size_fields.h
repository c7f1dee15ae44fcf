// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/features/tensor_settings.h>

namespace linelet::apps {

/** \brief Fields of the cloud that set the size of each point's neighborhood. */
struct SizeFields {
  std::string radius, knn; // names; empty: none

  const std::string&
  name() const
  {
    return radius.empty() ? knn : radius;
  }
};

/** \brief Sizes of neighborhoods from the values of \a fields, if there are any. */
NeighborhoodSizes
sizesFrom(const std::vector<double>& values, const SizeFields& fields);

/** \brief A radius for points of which only the scale unit is known. */
double
radiusFor(double scale_unit);

/** \brief The same if none was given for the points of \a file.
 * \throws std::runtime_error if they have no scale unit */
double
chooseRadius(double scale_unit, const std::string& file);

/** \brief The size of the neighborhoods, as text. */
std::string
describeSize(const TensorSettings& settings, const SizeFields& fields);

} // namespace linelet::apps
