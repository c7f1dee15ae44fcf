// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/tensor_record.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <linelet/tensor/eigen_analysis.h>
#include <linelet/tensor/shape_factors.h>

namespace linelet {

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
  return recordOf(
      neighborhoodTensor(
          offsets, reference, radius, settings.weighting, settings.normalization),
      std::sqrt(extent),
      static_cast<std::uint32_t>(offsets.size()));
}

} // namespace linelet
