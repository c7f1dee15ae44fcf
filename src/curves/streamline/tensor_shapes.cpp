// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tensor_shapes.h"

#include <algorithm>

#include <linelet/tensor/eigen_analysis.h>
#include <linelet/tensor/shape_factors.h>

namespace linelet {

MultiScaleShapes
shapesOfTensors(const std::vector<SymmetricTensor>& tensors,
                double scale_unit,
                const StreamlineSettings& settings)
{
  MultiScaleShapes result;
  result.scale_unit = scale_unit;
  const double factor = settings.interpolation_radius > 0
                            ? settings.interpolation_radius
                            : StreamlineSettings().interpolation_radius;
  result.radii = {factor * scale_unit};
  for (const SymmetricTensor& tensor : tensors) {
    MultiScaleShape shape;
    // Background is zero, and noise can make a diffusion negative.
    if (tensor.matrix().allFinite() && tensor.trace() > 0) {
      const EigenSystem system = eigenAnalysis(tensor);
      const ShapeFactors factors = shapeFactors(system.values);
      shape.linearity = static_cast<float>(factors.linearity);
      shape.planarity = static_cast<float>(factors.planarity);
      shape.sphericity = static_cast<float>(factors.sphericity);
      shape.min_sphericity = shape.sphericity;
      shape.linearity_sum = shape.linearity_max = shape.linearity;
      shape.optimal_radius = static_cast<float>(result.radii[0]);
      shape.blend = std::clamp(shape.linearity, 0.05F, 0.95F);
      const Point e3 = system.major();
      shape.major_x = static_cast<float>(e3.x());
      shape.major_y = static_cast<float>(e3.y());
      shape.major_z = static_cast<float>(e3.z());
      shape.neighbors = shape.first_neighbors = settings.min_start_neighbors;
      shape.scale = 0;
    }
    result.shapes.push_back(shape);
  }
  return result;
}

} // namespace linelet
