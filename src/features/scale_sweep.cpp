// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <features/scale_sweep.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <linelet/tensor/eigen_analysis.h>

namespace linelet {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr SymmetricTensor undefined_tensor{nan, nan, nan, nan, nan, nan};

} // namespace

ScaleSweep::ScaleSweep(const std::vector<double>& radii,
                       const MultiScaleSettings& settings)
    : radii_(radii),
      weighting_(settings.weighting),
      centroid_weighting_(settings.centroid_weighting),
      centroid_(settings.centroid),
      linearity_(radii.size()),
      farthest_(radii.size()),
      factors_(radii.size()),
      neighbors_(radii.size()),
      beside_(radii.size()),
      tensors_(radii.size()),
      majors_(radii.size())
{
  for (const double radius : radii)
    squared_radii_.push_back(radius * radius);
  clear();
}

void
ScaleSweep::clear()
{
  arrived_.clear();
  squared_.clear();
  scale_.clear();
  std::fill(neighbors_.begin(), neighbors_.end(), 0);
  std::fill(beside_.begin(), beside_.end(), 0);
  std::fill(farthest_.begin(), farthest_.end(), 0.0);
}

void
ScaleSweep::add(const Point& offset, double squared)
{
  // In any cloud, most neighbors belong to the last scales.
  std::size_t scale = radii_.size() - 1;
  while (scale > 0 && squared <= squared_radii_[scale - 1])
    --scale;
  arrived_.push_back(offset);
  squared_.push_back(squared);
  scale_.push_back(static_cast<std::uint16_t>(scale));
  ++neighbors_[scale];
  beside_[scale] += squared > 0 ? 1 : 0;
  farthest_[scale] = std::max(farthest_[scale], squared);
}

void
ScaleSweep::run(std::size_t scales)
{
  sortByScale();
  if (weighting_.kernel() == Kernel::Const &&
      (centroid_ == Centroid::QueryPoint || centroid_ == Centroid::Mean))
    prefixMoments(scales);
  else
    weightedTensors(scales);

  for (std::size_t k = 0; k < scales; ++k) {
    // One neighbor beside the point spans a line whatever the shape of the cloud.
    if (beside_[k] < 2)
      tensors_[k] = undefined_tensor;
    const EigenSystem system = eigenAnalysis(tensors_[k]);
    factors_[k] = shapeFactors(system.values, std::sqrt(farthest_[k]));
    majors_[k] = system.major();
    linearity_[k] = factors_[k].linearity;
  }
}

void
ScaleSweep::sortByScale()
{
  std::vector<std::uint32_t> next(radii_.size(), 0);
  for (std::size_t k = 1; k < radii_.size(); ++k) {
    next[k] = neighbors_[k - 1];
    neighbors_[k] += neighbors_[k - 1];
    beside_[k] += beside_[k - 1];
    farthest_[k] = std::max(farthest_[k], farthest_[k - 1]);
  }
  sorted_.resize(arrived_.size());
  distance_.resize(arrived_.size());
  for (std::size_t i = 0; i < arrived_.size(); ++i) {
    const std::uint32_t place = next[scale_[i]]++;
    sorted_[place] = arrived_[i];
    distance_[place] = std::sqrt(squared_[i]);
  }
}

void
ScaleSweep::prefixMoments(std::size_t scales)
{
  SymmetricTensor second;
  Point first = Point::Zero();
  std::size_t i = 0;
  for (std::size_t k = 0; k < scales; ++k) {
    for (; i < neighbors_[k]; ++i) {
      second.add(1, sorted_[i]);
      first += sorted_[i];
    }
    const double count = static_cast<double>(neighbors_[k]);
    tensors_[k] = second;
    tensors_[k] *= count > 0 ? 1 / count : nan;
    if (centroid_ == Centroid::Mean) {
      const double uncentered = tensors_[k].trace();
      tensors_[k].add(-1, first / count);
      // Close together but far from the point: the difference is mostly rounding.
      if (tensors_[k].trace() < 1e-9 * uncentered) {
        const Points prefix(sorted_.begin(), sorted_.begin() + neighbors_[k]);
        const Point mean = centroid(Centroid::Mean, prefix, Point::Zero(), radii_[k]);
        tensors_[k] = neighborhoodTensor(prefix, mean, radii_[k], weighting_);
      }
    }
  }
}

void
ScaleSweep::weightedTensors(std::size_t scales)
{
  // From large to small: each neighborhood is a prefix of the next larger one.
  Point center = Point::Zero();
  for (std::size_t k = scales; k-- > 0;) {
    sorted_.resize(neighbors_[k]);
    if (centroid_ != Centroid::QueryPoint) {
      // The median of the larger neighborhood is near that of the smaller one.
      const bool near = centroid_ == Centroid::Median && k + 1 < scales;
      center =
          near ? medianFrom(sorted_, center)
               : centroid(
                     centroid_, sorted_, Point::Zero(), radii_[k], centroid_weighting_);
      tensors_[k] = neighborhoodTensor(sorted_, center, radii_[k], weighting_);
      continue;
    }
    const double inverse_radius = 1 / radii_[k];
    SymmetricTensor tensor;
    double total = 0;
    for (std::size_t i = 0; i < sorted_.size(); ++i) {
      const double weight = weighting_(distance_[i] * inverse_radius);
      tensor.add(weight, sorted_[i]);
      total += weight;
    }
    tensor *= total > 0 ? 1 / total : nan;
    tensors_[k] = tensor;
  }
}

} // namespace linelet
