// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "size_fields.h"

#include <cstdio>
#include <stdexcept>

namespace linelet::apps {

NeighborhoodSizes
sizesFrom(const std::vector<double>& values, const SizeFields& fields)
{
  NeighborhoodSizes sizes;
  if (!fields.radius.empty())
    sizes.radii = values;
  if (!fields.knn.empty())
    for (const double k : values)
      sizes.counts.push_back(k >= 1 && k < 4e9 ? static_cast<unsigned>(k) : 0);
  return sizes;
}

double
radiusFor(double scale_unit)
{
  return 3 * scale_unit;
}

double
chooseRadius(double scale_unit, const std::string& file)
{
  if (!(scale_unit > 0))
    throw std::runtime_error(file +
                             ": no radius can be chosen for fewer than two points, "
                             "or coincident ones; give --radius");
  return radiusFor(scale_unit);
}

std::string
describeSize(const TensorSettings& settings, const SizeFields& fields)
{
  char text[64];
  if (!fields.radius.empty())
    return "radius from field " + fields.radius;
  if (!fields.knn.empty())
    return "number of nearest points from field " + fields.knn;
  if (settings.k > 0)
    return std::to_string(settings.k) + " nearest points";
  std::snprintf(text, sizeof(text), "radius %.6g", settings.radius);
  return text;
}

} // namespace linelet::apps
