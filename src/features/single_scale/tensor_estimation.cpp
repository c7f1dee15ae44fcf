// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/tensor_estimation.h>

#include <algorithm>
#include <iterator>
#include <type_traits>

#include <linelet/features/engine_choice.h>
#include <linelet/features/grid_tensor_engine.h>
#include <linelet/search/grid_search.h>
#include <linelet/search/kd_tree.h>

namespace linelet {

namespace {

/** \brief A grid cell size that suits most of the radii. */
double
usualRadius(const TensorSettings& settings, const NeighborhoodSizes& sizes)
{
  if (settings.radius > 0)
    return settings.radius;
  std::vector<double> radii;
  std::copy_if(
      sizes.radii.begin(), sizes.radii.end(), std::back_inserter(radii), isRadius);
  if (radii.empty())
    return 1;
  const auto middle = radii.begin() + static_cast<std::vector<double>::difference_type>(
                                          radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle;
}

} // namespace

std::vector<PointDistributionTensor>
estimateTensors(const Points& surface,
                const Points& queries,
                const TensorSettings& settings,
                const NeighborhoodSizes& sizes,
                ProgressMonitor* monitor)
{
  validate(settings, sizes, queries.size());
  // The only place where an engine is chosen.
  if (chosenEngine(surface, queries, settings, sizes) == Engine::Grid) {
    if (settings.radius > 0 || !sizes.radii.empty())
      return estimateTensorsOnGrid(surface, queries, settings, sizes, monitor);
    const GridSearch search(surface, usualRadius(settings, sizes));
    return estimateTensors(search, surface, queries, settings, sizes, monitor);
  }
  const KdTree search(surface);
  return estimateTensors(search, surface, queries, settings, sizes, monitor);
}

std::vector<PointDistributionTensor>
pieceTensors(const Points& points,
             const CloudPiece& piece,
             const TensorSettings& settings,
             const NeighborhoodSizes& sizes,
             ProgressMonitor* monitor)
{
  validate(settings, sizes, points.size());
  const bool nearest = settings.k > 0 || !sizes.counts.empty();
  if (!nearest && chosenEngine(points, points, settings, sizes) == Engine::Grid)
    return pieceTensorsOnGrid(points, piece, settings, sizes, monitor);
  const auto part = [&](const auto& values) {
    return values.empty()
               ? values
               : std::decay_t<decltype(values)>(
                     values.begin() + static_cast<std::ptrdiff_t>(piece.begin),
                     values.begin() + static_cast<std::ptrdiff_t>(piece.end));
  };
  return estimateTensors(
      points, part(points), settings, {part(sizes.radii), part(sizes.counts)}, monitor);
}

double
tensorMargin(const TensorSettings& settings, const NeighborhoodSizes& sizes)
{
  return gridMargin(settings, sizes); // the widest of all engines
}

} // namespace linelet
