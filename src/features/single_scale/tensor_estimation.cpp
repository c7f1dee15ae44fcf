// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/tensor_estimation.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

#include <linelet/features/engine_choice.h>
#include <linelet/features/grid_tensor_engine.h>
#include <linelet/search/grid_search.h>
#include <linelet/search/kd_tree.h>
#include <linelet/support/text.h>
#include <linelet/support/threads.h>
#include <linelet/tensor/eigen_analysis.h>
#include <linelet/tensor/neighborhood_tensor.h>
#include <linelet/tensor/shape_factors.h>

namespace linelet {

namespace {

bool
isSize(double radius)
{
  return radius > 0 && std::isfinite(radius);
}

/** \brief A size of grid cell that suits most of the radii. */
double
usualRadius(const TensorSettings& settings, const NeighborhoodSizes& sizes)
{
  if (settings.radius > 0)
    return settings.radius;
  std::vector<double> radii;
  std::copy_if(
      sizes.radii.begin(), sizes.radii.end(), std::back_inserter(radii), isSize);
  if (radii.empty())
    return 1;
  const auto middle = radii.begin() + static_cast<std::vector<double>::difference_type>(
                                          radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle;
}

/** \brief Makes one record after the other; one maker a thread. */
class RecordMaker {
public:
  RecordMaker(const NeighborSearch& search,
              const Points& surface,
              const TensorSettings& settings,
              const NeighborhoodSizes& sizes)
      : search_(search), surface_(surface), settings_(settings), sizes_(sizes)
  {
  }

  PointDistributionTensor
  operator()(const Point& query, std::size_t i)
  {
    if (!query.allFinite())
      return unknownTensor(0);
    const double radius = find(query, i);
    if (found_.empty())
      return unknownTensor(0);
    offsets_.resize(found_.size());
    for (std::size_t n = 0; n < found_.size(); ++n)
      offsets_[n] = surface_[found_[n]] - query;
    return tensorOf(offsets_, radius, settings_);
  }

private:
  double
  find(const Point& query, std::size_t i)
  {
    found_.clear();
    if (settings_.k > 0 || !sizes_.counts.empty()) {
      const std::size_t k = settings_.k > 0 ? settings_.k : sizes_.counts[i];
      return search_.nearest(query, k, found_);
    }
    const double radius = settings_.radius > 0 ? settings_.radius : sizes_.radii[i];
    if (isSize(radius))
      search_.within(query, radius, found_);
    return radius;
  }

  const NeighborSearch& search_;
  const Points& surface_;
  const TensorSettings& settings_;
  const NeighborhoodSizes& sizes_;
  Indices found_;
  Points offsets_;
};

} // namespace

void
validate(const TensorSettings& settings,
         const NeighborhoodSizes& sizes,
         std::size_t queries)
{
  const int said = (settings.radius != 0) + (settings.k != 0) + !sizes.radii.empty() +
                   !sizes.counts.empty();
  if (said == 0 && queries > 0)
    throw std::invalid_argument(
        "no size of neighborhood is given: say a radius, or the "
        "number k of nearest points");
  if (said > 1)
    throw std::invalid_argument("more than one size of neighborhood is given: say "
                                "either one radius, or one k, or sizes point by point");
  if (settings.radius != 0 && !isSize(settings.radius))
    throw std::invalid_argument("radius " + textOf(settings.radius) +
                                " is not a positive finite number");
  const std::size_t given = std::max(sizes.radii.size(), sizes.counts.size());
  if (given != 0 && given != queries)
    throw std::invalid_argument(std::to_string(given) +
                                " sizes of neighborhoods are given for " +
                                std::to_string(queries) + " points");
}

PointDistributionTensor
unknownTensor(std::uint32_t neighbors)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  return {nan,
          nan,
          nan,
          nan,
          nan,
          nan,
          nan,
          nan,
          nan,
          nan,
          nan,
          nan,
          nan,
          nan,
          nan,
          nan,
          nan,
          nan,
          neighbors};
}

PointDistributionTensor
recordOf(const SymmetricTensor& t, double extent, std::uint32_t neighbors)
{
  const EigenSystem system = eigenAnalysis(t);
  const ShapeFactors shape = shapeFactors(system.values, extent);
  if (std::isnan(shape.linearity))
    return unknownTensor(neighbors);

  const auto f = [](double value) { return static_cast<float>(value); };
  const Point major = system.major(), normal = system.normal();
  return {f(t.xx),
          f(t.xy),
          f(t.xz),
          f(t.yy),
          f(t.yz),
          f(t.zz),
          f(system.values[0]),
          f(system.values[1]),
          f(system.values[2]),
          f(major.x()),
          f(major.y()),
          f(major.z()),
          f(normal.x()),
          f(normal.y()),
          f(normal.z()),
          f(shape.linearity),
          f(shape.planarity),
          f(shape.sphericity),
          neighbors};
}

PointDistributionTensor
tensorOf(const Points& offsets, double radius, const TensorSettings& settings)
{
  const Point reference = centroid(
      settings.centroid, offsets, Point::Zero(), radius, settings.centroid_weighting);
  double extent = 0;
  for (const Point& offset : offsets)
    extent = std::max(extent, offset.squaredNorm());
  return recordOf(neighborhoodTensor(offsets, reference, radius, settings.weighting),
                  std::sqrt(extent),
                  static_cast<std::uint32_t>(offsets.size()));
}

std::vector<PointDistributionTensor>
estimateTensors(const NeighborSearch& search,
                const Points& surface,
                const Points& queries,
                const TensorSettings& settings,
                const NeighborhoodSizes& sizes,
                ProgressMonitor* monitor)
{
  validate(settings, sizes, queries.size());
  std::vector<PointDistributionTensor> records(queries.size());
  if (monitor != nullptr)
    monitor->begin("tensor", queries.size());
  constexpr std::size_t block = 512;
  const auto blocks = static_cast<std::ptrdiff_t>((queries.size() + block - 1) / block);
  std::atomic<bool> stop{false};
#pragma omp parallel num_threads(threadCount(settings.threads))
  {
    RecordMaker make(search, surface, settings, sizes);
#pragma omp for schedule(dynamic)
    for (std::ptrdiff_t b = 0; b < blocks; ++b) {
      if (stop)
        continue;
      const std::size_t begin = static_cast<std::size_t>(b) * block;
      const std::size_t end = std::min(begin + block, queries.size());
      for (std::size_t i = begin; i < end; ++i) {
        records[i] = make(queries[i], i);
        if (monitor != nullptr && monitor->canceled())
          break; // neighborhoods may be the whole cloud
      }
      if (monitor != nullptr) {
        monitor->advance(end - begin);
        if (monitor->canceled())
          stop = true;
      }
    }
  }
  if (stop)
    throw Canceled();
  return records;
}

std::vector<PointDistributionTensor>
estimateTensors(const Points& surface,
                const Points& queries,
                const TensorSettings& settings,
                const NeighborhoodSizes& sizes,
                ProgressMonitor* monitor)
{
  validate(settings, sizes, queries.size());
  // The place where engines are chosen.
  if (settings.engine == Engine::OpenCL)
    throw std::invalid_argument(
        "the engine opencl runs through opencl::TensorEngine or "
        "PointDistributionTensorEstimationOCL");
  if (chosenEngine(surface, queries, settings, sizes) == Engine::Grid) {
    if (settings.radius > 0 || !sizes.radii.empty())
      return estimateTensorsOnGrid(surface, queries, settings, sizes, monitor);
    const GridSearch search(surface, usualRadius(settings, sizes));
    return estimateTensors(search, surface, queries, settings, sizes, monitor);
  }
  const KdTree search(surface);
  return estimateTensors(search, surface, queries, settings, sizes, monitor);
}

} // namespace linelet
