// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/tensor/neighborhood_tensor.h>

#include <limits>

namespace linelet {

SymmetricTensor
neighborhoodTensor(const Points& neighbors,
                   const Point& centroid,
                   double radius,
                   const Weighting& weighting,
                   Normalization normalization)
{
  const double inverse_radius = radius > 0 ? 1 / radius : 0;
  SymmetricTensor tensor;
  double total = 0;
  for (const Point& neighbor : neighbors) {
    const Point v = neighbor - centroid;
    const double weight = weighting(v.norm() * inverse_radius);
    tensor.add(weight, v);
    total += weight;
  }
  if (normalization == Normalization::Count)
    total = static_cast<double>(neighbors.size());
  tensor *= total > 0 ? 1 / total : std::numeric_limits<double>::quiet_NaN();
  return tensor;
}

} // namespace linelet
