// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/multi_scale_radii.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <linelet/support/text.h>

namespace linelet {

namespace {

constexpr std::size_t most_radii = 4096;

/// So that rounding does not drop the largest radius.
constexpr double tolerance = 1 + 1e-12;

} // namespace

std::vector<double>
radiusSequence(RadiusGrowth growth, double scale_unit, double max_radius)
{
  if (!(scale_unit > 0) || !std::isfinite(scale_unit))
    throw std::invalid_argument("scale unit " + textOf(scale_unit) +
                                " is not positive and finite");
  if (max_radius == 0)
    max_radius = default_largest_radius * scale_unit;
  if (!std::isfinite(max_radius) || !(max_radius * tolerance >= scale_unit))
    throw std::invalid_argument(
        "largest radius " + textOf(max_radius) +
        " is not a finite number of at least the scale unit D = " + textOf(scale_unit));
  std::vector<double> radii;
  for (std::size_t k = 0;; ++k) {
    const double steps = static_cast<double>(k);
    const double radius = growth == RadiusGrowth::Exponential
                              ? scale_unit * std::pow(1.5, steps)
                              : scale_unit * (steps + 1);
    if (radius > max_radius * tolerance)
      return radii;
    if (radii.size() == most_radii)
      throw std::invalid_argument("largest radius " + textOf(max_radius) +
                                  " is more than " + std::to_string(most_radii) +
                                  " steps from D = " + textOf(scale_unit) +
                                  "; use exponential growth");
    radii.push_back(radius);
  }
}

void
checkRadii(const std::vector<double>& radii)
{
  if (radii.empty() || radii.size() > most_radii)
    throw std::invalid_argument("there must be 1 to " + std::to_string(most_radii) +
                                " radii, not " + std::to_string(radii.size()));
  for (std::size_t k = 0; k < radii.size(); ++k)
    if (!std::isfinite(radii[k]) || !(radii[k] > (k == 0 ? 0.0 : radii[k - 1])))
      throw std::invalid_argument("radius " + textOf(radii[k]) +
                                  " is not positive, finite and larger than the one "
                                  "before it");
}

} // namespace linelet
