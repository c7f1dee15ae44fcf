// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/streamline_settings.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <linelet/support/text.h>

namespace linelet {

namespace {

void
require(bool holds, const char* name, double value, const char* range)
{
  if (!holds)
    throw std::invalid_argument(std::string(name) + " is " + textOf(value) +
                                " but must be " + range);
}

void
requirePositive(const char* name, double value)
{
  require(value > 0 && std::isfinite(value), name, value, "positive and finite");
}

void
requireNotNegative(const char* name, double value)
{
  require(value >= 0 && std::isfinite(value), name, value, "0 or positive, and finite");
}

} // namespace

void
validate(const StreamlineSettings& s)
{
  requireNotNegative("distance-cutoff", s.distance_cutoff);
  requireNotNegative("largest-radius", s.largest_radius);
  requirePositive("tolerance", s.tolerance);
  requireNotNegative("start-threshold", s.start_threshold);
  require(s.seed_direction.empty() || s.seed_direction.size() == 3,
          "seed-direction",
          static_cast<double>(s.seed_direction.size()),
          "three numbers X,Y,Z");
  requireNotNegative("interpolation-radius", s.interpolation_radius);
  requirePositive("step", s.step);
  requirePositive("search-radius", s.search_radius);
  requireNotNegative("merge-distance", s.merge_distance);
  require(s.branch_angle > 0 && s.branch_angle <= 180,
          "branch-angle",
          s.branch_angle,
          "of (0, 180] degrees");
  requireNotNegative("prune-distance", s.prune_distance);
  requireNotNegative("cover-distance", s.cover_distance);
  requireNotNegative("stump-length", s.stump_length);
  requireNotNegative("start-neighbor-exponent", s.start_neighbor_exponent);
  requireNotNegative("prefilter-radius", s.prefilter.radius);
  if (!s.tensors.empty() && (s.direction == DirectionMode::MultiScaleAngular ||
                             s.direction == DirectionMode::ComputedAngular))
    throw std::invalid_argument(
        "direction " + std::string(nameOf(s.direction)) +
        " measures shapes at every step and cannot follow given tensors");
}

} // namespace linelet
