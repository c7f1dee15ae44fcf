// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plain loops over the pixels of a block, which the compiler turns into vectors of
// every instruction set. Nothing is fused or reordered: all sets give the same bits.

#include "normal_kernels.h"

#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "screen/normal_kernels.cpp"
#include <hwy/foreach_target.h> // includes this file once per instruction set

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linelet::screen {
namespace HWY_NAMESPACE {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

/** \brief The largest square of a distance that takes part. */
inline float
limitOf(const ScreenNormalSettings& settings)
{
  const auto distance = static_cast<float>(settings.max_distance);
  return distance > 0 ? distance * distance : std::numeric_limits<float>::infinity();
}

/** \brief Sums of outer products of directions. */
struct Tensors {
  float xx[block], xy[block], xz[block], yy[block], yz[block], zz[block];
};

inline void
addDirections(const float* HWY_RESTRICT x,
              const float* HWY_RESTRICT y,
              const float* HWY_RESTRICT z,
              const float* HWY_RESTRICT cx,
              const float* HWY_RESTRICT cy,
              const float* HWY_RESTRICT cz,
              float limit,
              Tensors& t)
{
  for (int i = 0; i < block; ++i) {
    const float dx = x[i] - cx[i], dy = y[i] - cy[i], dz = z[i] - cz[i];
    const float square = (dx * dx + dy * dy) + dz * dz;
    const bool counts = (square > 0) & (square <= limit);
    const float weight = 1 / (counts ? square : 1);
    const float a = counts ? dx : 0, b = counts ? dy : 0, c = counts ? dz : 0;
    const float wa = weight * a, wb = weight * b, wc = weight * c;
    t.xx[i] += wa * a;
    t.xy[i] += wa * b;
    t.xz[i] += wa * c;
    t.yy[i] += wb * b;
    t.yz[i] += wb * c;
    t.zz[i] += wc * c;
  }
}

/** \brief Turns axes p and q so that the entry between them vanishes (Jacobi). */
#define LINELET_ROTATE(app, aqq, apq, apr, aqr, p, q)                                  \
  {                                                                                    \
    const float diff = aqq - app, twice = apq + apq;                                   \
    const float root = std::sqrt(diff * diff + twice * twice);                         \
    const float below = diff < 0 ? diff - root : diff + root;                          \
    const float tangent = below != 0 ? twice / (below != 0 ? below : 1) : 0;           \
    const float cosine = 1 / std::sqrt(tangent * tangent + 1);                         \
    const float sine = tangent * cosine;                                               \
    app -= tangent * apq;                                                              \
    aqq += tangent * apq;                                                              \
    apq = 0;                                                                           \
    const float pr = apr, px = p[0], py = p[1], pz = p[2];                             \
    apr = cosine * pr - sine * aqr;                                                    \
    aqr = cosine * aqr + sine * pr;                                                    \
    p[0] = cosine * px - sine * q[0];                                                  \
    q[0] = cosine * q[0] + sine * px;                                                  \
    p[1] = cosine * py - sine * q[1];                                                  \
    q[1] = cosine * q[1] + sine * py;                                                  \
    p[2] = cosine * pz - sine * q[2];                                                  \
    q[2] = cosine * q[2] + sine * pz;                                                  \
  }

/** \brief The eigenvectors of the smallest eigenvalues; NaN where two of the three are
 * nothing: one direction alone has no normal. */
inline void
smallest(const Tensors& t, NormalBlock& out)
{
  for (int i = 0; i < block; ++i) {
    const float trace = (t.xx[i] + t.yy[i]) + t.zz[i];
    const float scale = 1 / (trace > 0 ? trace : 1);
    float xx = t.xx[i] * scale, xy = t.xy[i] * scale, xz = t.xz[i] * scale;
    float yy = t.yy[i] * scale, yz = t.yz[i] * scale, zz = t.zz[i] * scale;
    float u[3] = {1, 0, 0}, v[3] = {0, 1, 0}, w[3] = {0, 0, 1};
    for (int turn = 0; turn < 4; ++turn) {
      LINELET_ROTATE(xx, yy, xy, xz, yz, u, v)
      LINELET_ROTATE(xx, zz, xz, xy, yz, u, w)
      LINELET_ROTATE(yy, zz, yz, xy, xz, v, w)
    }
    const bool by_y = yy < xx;
    float least = by_y ? yy : xx;
    float nx = by_y ? v[0] : u[0], ny = by_y ? v[1] : u[1], nz = by_y ? v[2] : u[2];
    const bool by_z = zz < least;
    least = by_z ? zz : least;
    nx = by_z ? w[0] : nx;
    ny = by_z ? w[1] : ny;
    nz = by_z ? w[2] : nz;
    const float most = xx > yy ? (xx > zz ? xx : zz) : (yy > zz ? yy : zz);
    constexpr float nothing = 1e-6F;
    const bool known = (trace > 0) & (1 - most - least > nothing);
    out.x[i] = known ? nx : unknown;
    out.y[i] = known ? ny : unknown;
    out.z[i] = known ? nz : unknown;
  }
}

inline void
tensorNormals(
    const PaddedSamples& s, int rings, float limit, std::ptrdiff_t at, NormalBlock& out)
{
  Tensors t = {};
  const auto add = [&](std::ptrdiff_t place) {
    for (int layer = 0; layer < s.layers; ++layer) {
      const std::ptrdiff_t from = layer * s.layer + place;
      addDirections(s.x.data() + from,
                    s.y.data() + from,
                    s.z.data() + from,
                    s.cx.data() + at,
                    s.cy.data() + at,
                    s.cz.data() + at,
                    limit,
                    t);
    }
  };
  add(at);
  for (int ring = 0; ring < rings; ++ring)
    for (const auto& place : ring_places[ring])
      add(at + place[1] * s.stride + place[0]);
  smallest(t, out);
}

/** \brief Adds (a - b) x (c - d) where all four count. */
inline void
addCross(const PaddedSamples& s,
         std::ptrdiff_t a,
         std::ptrdiff_t b,
         std::ptrdiff_t c,
         std::ptrdiff_t d,
         std::ptrdiff_t at,
         float limit,
         NormalBlock& sum)
{
  const float *x = s.x.data(), *y = s.y.data(), *z = s.z.data();
  const float *cx = s.cx.data() + at, *cy = s.cy.data() + at, *cz = s.cz.data() + at;
  const auto near = [&](std::ptrdiff_t k, int i) {
    const float dx = x[k + i] - cx[i], dy = y[k + i] - cy[i], dz = z[k + i] - cz[i];
    return (dx * dx + dy * dy) + dz * dz <= limit;
  };
  for (int i = 0; i < block; ++i) {
    const float ux = x[a + i] - x[b + i], uy = y[a + i] - y[b + i],
                uz = z[a + i] - z[b + i];
    const float vx = x[c + i] - x[d + i], vy = y[c + i] - y[d + i],
                vz = z[c + i] - z[d + i];
    const bool counts = near(a, i) & near(b, i) & near(c, i) & near(d, i);
    sum.x[i] += counts ? uy * vz - uz * vy : 0;
    sum.y[i] += counts ? uz * vx - ux * vz : 0;
    sum.z[i] += counts ? ux * vy - uy * vx : 0;
  }
}

/** \brief Adds the unit normal of the triangle a, b, c, c being every pixel's own
 * position. */
inline void
addCorner(const PaddedSamples& s,
          const float* HWY_RESTRICT x,
          const float* HWY_RESTRICT y,
          const float* HWY_RESTRICT z,
          std::ptrdiff_t a,
          std::ptrdiff_t b,
          std::ptrdiff_t at,
          float limit,
          NormalBlock& sum)
{
  const float *cx = s.cx.data() + at, *cy = s.cy.data() + at, *cz = s.cz.data() + at;
  for (int i = 0; i < block; ++i) {
    const float ux = x[a + i] - cx[i], uy = y[a + i] - cy[i], uz = z[a + i] - cz[i];
    const float vx = x[b + i] - cx[i], vy = y[b + i] - cy[i], vz = z[b + i] - cz[i];
    const float nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const float square = (nx * nx + ny * ny) + nz * nz;
    const bool counts = ((ux * ux + uy * uy) + uz * uz <= limit) &
                        ((vx * vx + vy * vy) + vz * vz <= limit) & (square > 0);
    const float scale = 1 / std::sqrt(counts ? square : 1);
    sum.x[i] += counts ? nx * scale : 0;
    sum.y[i] += counts ? ny * scale : 0;
    sum.z[i] += counts ? nz * scale : 0;
  }
}

/** \brief To unit length; NaN where there is none. */
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
  const float *x = s.cx.data(), *y = s.cy.data(), *z = s.cz.data();
  // Forwards, or backwards where that is missing.
  const auto sum = [&](std::ptrdiff_t down, std::ptrdiff_t right) {
    addCorner(s, x, y, z, at + down, at + right, at, limit, out);
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
  for (int layer = 0; layer < s.layers; ++layer)
    for (int ring = 0; ring < rings; ++ring) {
      std::ptrdiff_t k[4];
      for (int corner = 0; corner < 4; ++corner)
        k[corner] = layer * s.layer + at + ring_places[ring][corner][1] * s.stride +
                    ring_places[ring][corner][0];
      if (settings.method == ScreenNormalMethod::PlaneDiagonals)
        addCross(s, k[0], k[2], k[1], k[3], at, limit, out);
      else
        for (int corner = 0; corner < 4; ++corner)
          addCorner(s,
                    s.x.data(),
                    s.y.data(),
                    s.z.data(),
                    k[corner],
                    k[(corner + 1) % 4],
                    at,
                    limit,
                    out);
    }
  normalize(out);
}

NormalKernels
kernels()
{
  return {normals};
}

#undef LINELET_ROTATE

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
