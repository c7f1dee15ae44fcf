// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <linelet/curves/reconstruct_curves.h>
#include <linelet/features/tensor_estimation.h>

int
main()
{
  linelet::Points points;
  for (double t = 0; t < 6.28; t += 0.02)
    points.emplace_back(5 * std::cos(t), 5 * std::sin(t), 0);
  linelet::TensorSettings settings;
  settings.radius = 0.5;
  const auto tensors = linelet::estimateTensors(points, points, settings);
  if (!(tensors.front().linearity > 0.9F))
    return 1;
  try {
    settings.radius = -1;
    linelet::estimateTensors(points, points, settings);
    return 2;
  }
  catch (const std::invalid_argument&) {
  }
  return linelet::reconstructCurves(points, {}).curves.size() == 1 ? 0 : 3;
}
