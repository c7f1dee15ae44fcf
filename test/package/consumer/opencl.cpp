// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/opencl/device.h>
#include <linelet/opencl/tensor_engine.h>

int
main()
{
  if (linelet::opencl::devices().empty())
    return 0;
  linelet::Points points;
  for (int i = 0; i < 100; ++i)
    points.emplace_back(0.1 * i, 0, 0);
  linelet::TensorSettings settings;
  settings.radius = 1;
  linelet::opencl::TensorEngine engine;
  return engine.estimate(points, points, settings).size() == points.size() ? 0 : 1;
}
