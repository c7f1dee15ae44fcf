// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plain loops over the pixels of a block, which the compiler turns into vectors of
// every instruction set. Nothing is fused or reordered: all sets give the same bits.

#include "normal_kernels.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "screen/normal_kernels.cpp"
#include <hwy/foreach_target.h> // includes this file once per instruction set

#include <hwy/highway.h>

#include "pixel_lanes-inl.h"
#include "smoothing-inl.h"
#include "tensor_normals-inl.h"
#include "triangle_normals-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::screen {
namespace HWY_NAMESPACE {

/** \brief The squared distance limit of samples. */
inline float
limitOf(const ScreenNormalSettings& settings)
{
  const auto distance = static_cast<float>(settings.max_distance);
  return distance > 0 ? distance * distance : std::numeric_limits<float>::infinity();
}

void
normals(const PaddedSamples& s,
        const ScreenNormalSettings& settings,
        int column,
        int row,
        NormalBlock& out)
{
  // Lengths in the unit of the cloud can be tiny or huge; their squares' squares fit.
  const float limit = limitOf(settings);
  const std::ptrdiff_t at = s.at(column, row);
  const int rings = ringsOf(settings.samples);
  if (settings.method == ScreenNormalMethod::Tensor) {
    tensorNormals(s, rings, limit, at, out);
    return;
  }
  if (settings.method == ScreenNormalMethod::LocalDerivatives) {
    derivativeNormals(s, limit, at, out);
    return;
  }
  out = {};
  const Places own(s.cx.data(), s.cy.data(), s.cz.data(), at);
  for (int layer = 0; layer < s.layers; ++layer)
    for (int ring = 0; ring < rings; ++ring) {
      const auto corner = [&](int number) {
        const auto& place = ring_places[ring][number % 4];
        return Places(s.x.data(),
                      s.y.data(),
                      s.z.data(),
                      layer * s.layer + at + place[1] * s.stride + place[0]);
      };
      if (settings.method == ScreenNormalMethod::PlaneDiagonals)
        addCross(corner(0), corner(2), corner(1), corner(3), own, limit, out);
      else
        for (int k = 0; k < 4; ++k)
          addCorner(corner(k), corner(k + 1), own, limit, out);
    }
  normalize(out);
}

void
positions(PaddedSamples& s, float limit, int column, int row)
{
  const std::ptrdiff_t at = s.at(column, row);
  Vectors first = {}, sum = {};
  float count[block] = {};
  for (int layer = 0; layer < s.layers; ++layer) {
    const Places p(s.x.data(), s.y.data(), s.z.data(), layer * s.layer + at);
    for (int i = 0; i < block; ++i) {
      // The difference is NaN where one is infinite.
      const bool finite =
          (p.x[i] - p.x[i] == 0) & (p.y[i] - p.y[i] == 0) & (p.z[i] - p.z[i] == 0);
      const bool begins = finite & (count[i] == 0);
      first.x[i] = begins ? p.x[i] : first.x[i];
      first.y[i] = begins ? p.y[i] : first.y[i];
      first.z[i] = begins ? p.z[i] : first.z[i];
      const float dx = p.x[i] - first.x[i], dy = p.y[i] - first.y[i],
                  dz = p.z[i] - first.z[i];
      const bool counts = finite & ((dx * dx + dy * dy) + dz * dz <= limit);
      sum.x[i] += counts ? dx : 0;
      sum.y[i] += counts ? dy : 0;
      sum.z[i] += counts ? dz : 0;
      count[i] += counts ? 1 : 0;
    }
  }
  float *HWY_RESTRICT x = s.cx.data() + at, *HWY_RESTRICT y = s.cy.data() + at,
                      *HWY_RESTRICT z = s.cz.data() + at;
  for (int i = 0; i < block; ++i) {
    const bool any = count[i] > 0;
    const float number = any ? count[i] : 1;
    x[i] = any ? first.x[i] + sum.x[i] / number : unknown;
    y[i] = any ? first.y[i] + sum.y[i] / number : unknown;
    z[i] = any ? first.z[i] + sum.z[i] / number : unknown;
  }
}

NormalKernels
kernels()
{
  return {positions, normals, smooth};
}

} // namespace HWY_NAMESPACE
} // namespace linelet::screen
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace linelet::screen {

HWY_EXPORT(kernels);

NormalKernels
normalKernels()
{
  return HWY_DYNAMIC_DISPATCH(kernels)();
}

} // namespace linelet::screen

#endif
