// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "streamline_points.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <linelet/features/centroid_shift.h>
#include <linelet/search/scale_unit.h>

#include "search/finite_points.h"

namespace linelet {

namespace {

/** \brief \a chosen without duplicates, sorted by position. */
Indices
withoutRepetition(const Points& points, Indices chosen)
{
  std::sort(chosen.begin(), chosen.end(), [&](Index i, Index j) {
    const Point &a = points[i], &b = points[j];
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  });
  const auto same = [&](Index i, Index j) { return points[i] == points[j]; };
  chosen.erase(std::unique(chosen.begin(), chosen.end(), same), chosen.end());
  return chosen;
}

} // namespace

StreamlinePoints::StreamlinePoints(const Points& all,
                                   const NeighborSearch* search,
                                   const StreamlineSettings& settings)
    : search_(search)
{
  choose(all, finiteOnes(all));
  measure(settings);
  if (scale_unit == 0) {
    subset_.reset();
    search_ = search;
    choose(all, withoutRepetition(all, finiteOnes(all)));
    measure(settings);
  }
  if (!(scale_unit > 0))
    return;
  if (settings.prefilter.radius > 0) {
    CentroidShiftSettings shift = settings.prefilter;
    shift.threads = settings.threads;
    points = search_ != nullptr ? shiftToCentroids(*search_, points, shift)
                                : shiftToCentroids(points, shift);
    search_ = nullptr; // it does not know the moved points
  }
  neighbors.emplace(points, 2.5 * scale_unit, search_);
}

Index
StreamlinePoints::placeOf(Index index, std::size_t all) const
{
  if (index >= all)
    throw std::invalid_argument("start " + std::to_string(index) +
                                " is not one of the " + std::to_string(all) +
                                " points, which count from 0");
  const auto found = std::find(chosen_.begin(), chosen_.end(), index);
  if (found == chosen_.end())
    throw std::invalid_argument(
        "start " + std::to_string(index) +
        " is a point without coordinates, left out, or a copy of another");
  return static_cast<Index>(found - chosen_.begin());
}

void
StreamlinePoints::choose(const Points& all, const Indices& chosen)
{
  points.clear();
  for (const Index i : chosen)
    points.push_back(all[i]);
  chosen_ = chosen;
  if (search_ == nullptr || chosen.size() == all.size())
    return;
  subset_.emplace(*search_, all, chosen);
  search_ = &*subset_;
}

void
StreamlinePoints::measure(const StreamlineSettings& settings)
{
  const MultiScaleSettings& shape = settings.shape;
  if (shape.scale_unit > 0)
    scale_unit = shape.scale_unit;
  else if (search_ != nullptr)
    scale_unit = scaleUnit(*search_,
                           points,
                           shape.scale_unit_sample,
                           shape.scale_unit_seed,
                           settings.threads);
  else
    scale_unit = scaleUnit(
        points, shape.scale_unit_sample, shape.scale_unit_seed, settings.threads);
}

} // namespace linelet
