// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "direction_field.h"

#include <cmath>

#include <features/scale_sweep.h>
#include <linelet/features/read_linearity_graph.h>
#include <linelet/features/tensor_estimation.h>
#include <linelet/tensor/eigen_analysis.h>

namespace linelet {

namespace {

// Directions whose weights sum to less are meaningless: all points lie behind the end.
constexpr double least_weight = 1e-3;

/** \brief \a v of length 1, or zero if it is too short to have a direction. */
Point
unit(const Point& v, double least = 1e-12)
{
  const double norm = v.norm();
  return norm > least ? Point(v / norm) : Point(Point::Zero());
}

Point
toward(const Point& direction, const Point& last)
{
  return direction.dot(last) < 0 ? Point(-direction) : direction;
}

/** \brief The tensor that the features of the points are based on. */
TensorSettings
tensorSettings(const StreamlineSettings& settings)
{
  TensorSettings tensor;
  tensor.weighting = settings.shape.weighting;
  tensor.centroid = settings.shape.centroid;
  tensor.centroid_weighting = settings.shape.centroid_weighting;
  tensor.threads = settings.threads;
  return tensor;
}

std::vector<SymmetricTensor>
optimalTensors(const Points& points,
               const NeighborSearch* search,
               const std::vector<LocalScale>& scales,
               const StreamlineSettings& settings)
{
  const TensorSettings tensor = tensorSettings(settings);
  NeighborhoodSizes sizes;
  for (const LocalScale& scale : scales)
    sizes.radii.push_back(scale.radius);
  const auto records = search != nullptr
                           ? estimateTensors(*search, points, points, tensor, sizes)
                           : estimateTensors(points, points, tensor, sizes);
  std::vector<SymmetricTensor> result;
  for (const PointDistributionTensor& record : records) {
    result.push_back(
        {record.xx, record.xy, record.xz, record.yy, record.yz, record.zz});
  }
  return result;
}

/** \brief \a t with trace 1, so that points with large neighborhoods do not outvote the
 * others. */
SymmetricTensor
normalized(SymmetricTensor t)
{
  const double trace = t.trace();
  t *= trace > 0 ? 1 / trace : 0;
  return trace > 0 ? t : SymmetricTensor{};
}

} // namespace

DirectionField::DirectionField(const Points& points,
                               const MultiScaleShapes& shapes,
                               const CloudNeighbors& neighbors,
                               const StreamlineSettings& settings,
                               const std::vector<SymmetricTensor>& tensors)
    : points_(points),
      neighbors_(neighbors),
      settings_(settings),
      scale_unit_(shapes.scale_unit),
      radii_(shapes.radii)
{
  for (const MultiScaleShape& shape : shapes.shapes) {
    eigenvectors_.emplace_back(shape.major_x, shape.major_y, shape.major_z);
    const bool known = std::isfinite(shape.optimal_radius);
    LocalScale scale;
    if (known) {
      scale.radius = scale.optimal_radius = double(shape.optimal_radius);
      scale.blend = double(shape.blend);
      scale.nearest = static_cast<Index>(scales_.size());
    }
    scales_.push_back(scale);
  }
  if (settings.direction == DirectionMode::Tensor ||
      settings.direction == DirectionMode::TensorDeflection)
    for (const SymmetricTensor& tensor :
         tensors.empty() ? optimalTensors(points, neighbors.search(), scales_, settings)
                         : tensors)
      tensors_.push_back(normalized(tensor));
}

LocalScale
DirectionField::scaleAt(const Point& position, const LocalScale& last) const
{
  const Index i = neighbors_.nearest(position, settings_.search_radius * scale_unit_);
  if (i == CloudNeighbors::none || scales_[i].radius == 0)
    return last;
  LocalScale scale = scales_[i];
  if (settings_.interpolation_radius > 0)
    scale.radius = settings_.interpolation_radius * scale_unit_;
  return scale;
}

Point
DirectionField::at(const Point& position,
                   const Point& last,
                   const LocalScale& scale) const
{
  Point direction = Point::Zero();
  switch (settings_.direction) {
  case DirectionMode::Eigenvector:
    direction = interpolatedEigenvector(position, last, scale.radius);
    break;
  case DirectionMode::Tensor: {
    const Eigen::Matrix3d t = interpolatedTensor(position, scale.radius);
    if (t.trace() > 0) {
      const SymmetricTensor sum{t(0, 0), t(0, 1), t(0, 2), t(1, 1), t(1, 2), t(2, 2)};
      direction = toward(eigenAnalysis(sum).major(), last);
    }
    break;
  }
  case DirectionMode::Angular:
    direction = angular(position, last, scale.radius, false);
    break;
  case DirectionMode::EigenvectorAngular:
    direction = scale.blend * interpolatedEigenvector(position, last, scale.radius) +
                (1 - scale.blend) * angular(position, last, scale.radius, false);
    break;
  case DirectionMode::TensorDeflection:
    direction = interpolatedTensor(position, scale.radius) * last;
    break;
  case DirectionMode::EigenvectorAngularDistance:
    direction = scale.blend * interpolatedEigenvector(position, last, scale.radius) +
                (1 - scale.blend) * angular(position, last, scale.radius, true);
    break;
  case DirectionMode::ClosestAngular:
    if (scale.nearest != CloudNeighbors::none)
      direction = scale.blend * toward(eigenvectors_[scale.nearest], last);
    direction += (1 - scale.blend) * angular(position, last, scale.radius, false);
    break;
  case DirectionMode::MultiScaleAngular: {
    double blend = scale.blend;
    const Point e3 = multiScaleEigenvector(position, last, blend);
    direction = blend * e3 + (1 - blend) * angular(position, last, scale.radius, false);
    break;
  }
  case DirectionMode::ComputedAngular:
    direction =
        scale.blend * computedEigenvector(position, last, scale.optimal_radius) +
        (1 - scale.blend) * angular(position, last, scale.radius, false);
    break;
  }
  direction = unit(direction);
  return direction.isZero() ? last : direction;
}

Point
DirectionField::computedEigenvector(const Point& position,
                                    const Point& last,
                                    double radius) const
{
  if (!(radius > 0))
    return Point::Zero();
  thread_local Points offsets;
  offsets.clear();
  neighbors_.forEachWithin(position, radius, [&](Index i, double) {
    offsets.push_back(points_[i] - position);
  });
  const PointDistributionTensor record =
      tensorOf(offsets, radius, tensorSettings(settings_));
  const Point major(record.major_x, record.major_y, record.major_z);
  return major.allFinite() ? toward(major, last) : Point(Point::Zero());
}

Point
DirectionField::multiScaleEigenvector(const Point& position,
                                      const Point& last,
                                      double& blend) const
{
  MultiScaleSettings shape = settings_.shape;
  ScaleSweep sweep(radii_, shape);
  neighbors_.forEachWithin(position, radii_.back(), [&](Index i, double squared) {
    sweep.add(points_[i] - position, squared);
  });
  sweep.run();
  const LinearityGraph graph =
      readLinearityGraph(sweep.linearity(), sweep.neighbors(), radii_, shape.graph);
  if (graph.scale() == LinearityGraph::none)
    return Point::Zero();
  blend = graph.blend;
  return toward(sweep.majors()[graph.scale()], last);
}

Point
DirectionField::interpolatedEigenvector(const Point& position,
                                        const Point& last,
                                        double radius) const
{
  Point sum = Point::Zero();
  double weights = 0;
  neighbors_.forEachWithin(position, radius, [&](Index i, double squared) {
    if (scales_[i].radius == 0)
      return;
    const double weight =
        settings_.interpolation_weighting(std::sqrt(squared) / radius);
    sum += weight * toward(eigenvectors_[i], last);
    weights += weight;
  });
  if (settings_.unit_eigenvector)
    return unit(sum);
  return weights > 0 ? Point(sum / weights) : Point(Point::Zero());
}

Point
DirectionField::angular(const Point& position,
                        const Point& last,
                        double radius,
                        bool with_distance) const
{
  Point sum = Point::Zero();
  double weights = 0;
  neighbors_.forEachWithin(position, radius, [&](Index i, double squared) {
    if (squared == 0)
      return;
    const double distance = std::sqrt(squared);
    const Point v = (points_[i] - position) / distance;
    double weight = settings_.angle_weighting(1 - (v.dot(last) + 1) / 2);
    if (with_distance)
      weight *= settings_.interpolation_weighting(distance / radius);
    sum += weight * v;
    weights += weight;
  });
  return weights > least_weight ? unit(sum) : Point(Point::Zero());
}

Eigen::Matrix3d
DirectionField::interpolatedTensor(const Point& position, double radius) const
{
  SymmetricTensor sum;
  neighbors_.forEachWithin(position, radius, [&](Index i, double squared) {
    SymmetricTensor t = tensors_[i];
    t *= settings_.interpolation_weighting(std::sqrt(squared) / radius);
    sum += t;
  });
  return sum.matrix();
}

} // namespace linelet
