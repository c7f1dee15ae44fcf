// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Normals as sums of cross products. Included once per instruction
// set, so it has a guard that toggles.

#if defined(LINELET_SCREEN_TRIANGLE_NORMALS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_SCREEN_TRIANGLE_NORMALS_INL
#undef LINELET_SCREEN_TRIANGLE_NORMALS_INL
#else
#define LINELET_SCREEN_TRIANGLE_NORMALS_INL
#endif

#include <cmath>

#include <hwy/highway.h>

#include "pixel_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::screen {
namespace HWY_NAMESPACE {

/** \brief Adds (a - b) x (c - d) where all four are near the own position o. */
inline void
addCross(
    Places a, Places b, Places c, Places d, Places o, float limit, NormalBlock& sum)
{
  float *HWY_RESTRICT sx = sum.x, *HWY_RESTRICT sy = sum.y, *HWY_RESTRICT sz = sum.z;
  const auto near = [&](const Places& p, int i) {
    const float dx = p.x[i] - o.x[i], dy = p.y[i] - o.y[i], dz = p.z[i] - o.z[i];
    return (dx * dx + dy * dy) + dz * dz <= limit;
  };
  for (int i = 0; i < block; ++i) {
    const float ux = a.x[i] - b.x[i], uy = a.y[i] - b.y[i], uz = a.z[i] - b.z[i];
    const float vx = c.x[i] - d.x[i], vy = c.y[i] - d.y[i], vz = c.z[i] - d.z[i];
    const bool counts = near(a, i) & near(b, i) & near(c, i) & near(d, i);
    sx[i] += counts ? uy * vz - uz * vy : 0;
    sy[i] += counts ? uz * vx - ux * vz : 0;
    sz[i] += counts ? ux * vy - uy * vx : 0;
  }
}

/** \brief Adds the unit normal of the triangle a, b and the own position o. */
inline void
addCorner(Places a, Places b, Places o, float limit, NormalBlock& sum)
{
  float *HWY_RESTRICT sx = sum.x, *HWY_RESTRICT sy = sum.y, *HWY_RESTRICT sz = sum.z;
  for (int i = 0; i < block; ++i) {
    const float ux = a.x[i] - o.x[i], uy = a.y[i] - o.y[i], uz = a.z[i] - o.z[i];
    const float vx = b.x[i] - o.x[i], vy = b.y[i] - o.y[i], vz = b.z[i] - o.z[i];
    const float nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const float square = (nx * nx + ny * ny) + nz * nz;
    const bool counts = ((ux * ux + uy * uy) + uz * uz <= limit) &
                        ((vx * vx + vy * vy) + vz * vz <= limit) & (square > 0);
    const float scale = 1 / std::sqrt(counts ? square : 1);
    sx[i] += counts ? nx * scale : 0;
    sy[i] += counts ? ny * scale : 0;
    sz[i] += counts ? nz * scale : 0;
  }
}

/** \brief Scales to unit length; NaN for zero length. */
inline void
normalize(NormalBlock& n)
{
  for (int i = 0; i < block; ++i) {
    const float square = (n.x[i] * n.x[i] + n.y[i] * n.y[i]) + n.z[i] * n.z[i];
    const bool known = square > 0;
    const float scale = known ? 1 / std::sqrt(known ? square : 1) : unknown;
    n.x[i] *= scale;
    n.y[i] *= scale;
    n.z[i] *= scale;
  }
}

inline void
derivativeNormals(const PaddedSamples& s,
                  float limit,
                  std::ptrdiff_t at,
                  NormalBlock& out)
{
  const auto own = [&](std::ptrdiff_t step) {
    return Places(s.cx.data(), s.cy.data(), s.cz.data(), at + step);
  };
  // Forward, or backward if that is missing.
  const auto sum = [&](std::ptrdiff_t down, std::ptrdiff_t right) {
    addCorner(own(down), own(right), own(0), limit, out);
  };
  out = {};
  sum(s.stride, 1);
  NormalBlock forward = out;
  out = {};
  sum(-s.stride, -1);
  for (int i = 0; i < block; ++i) {
    const bool found = (forward.x[i] != 0) | (forward.y[i] != 0) | (forward.z[i] != 0);
    out.x[i] = found ? forward.x[i] : out.x[i];
    out.y[i] = found ? forward.y[i] : out.y[i];
    out.z[i] = found ? forward.z[i] : out.z[i];
  }
  normalize(out);
}

} // namespace HWY_NAMESPACE
} // namespace linelet::screen
HWY_AFTER_NAMESPACE();

#endif
