// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Normals as the minor eigenvectors of tensors. Included once per instruction
// set, so it has a guard that toggles.

#if defined(LINELET_SCREEN_TENSOR_NORMALS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_SCREEN_TENSOR_NORMALS_INL
#undef LINELET_SCREEN_TENSOR_NORMALS_INL
#else
#define LINELET_SCREEN_TENSOR_NORMALS_INL
#endif

#include <cmath>

#include <hwy/highway.h>

#include "pixel_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::screen {
namespace HWY_NAMESPACE {

/** \brief Sums of outer products of directions, over their lengths. */
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
    const float weight = 1 / std::sqrt(counts ? square : 1);
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

/** \brief Rotates axes p and q so that the entry between them vanishes (Jacobi). */
inline void
rotate(float* HWY_RESTRICT app,
       float* HWY_RESTRICT aqq,
       float* HWY_RESTRICT apq,
       float* HWY_RESTRICT apr,
       float* HWY_RESTRICT aqr,
       Vectors& HWY_RESTRICT p,
       Vectors& HWY_RESTRICT q)
{
  for (int i = 0; i < block; ++i) {
    const float diff = aqq[i] - app[i], twice = apq[i] + apq[i];
    const float root = std::sqrt(diff * diff + twice * twice);
    const float below = diff < 0 ? diff - root : diff + root;
    const float tangent = below != 0 ? twice / (below != 0 ? below : 1) : 0;
    const float cosine = 1 / std::sqrt(tangent * tangent + 1);
    const float sine = tangent * cosine;
    app[i] -= tangent * apq[i];
    aqq[i] += tangent * apq[i];
    apq[i] = 0;
    const float pr = apr[i], qr = aqr[i];
    apr[i] = cosine * pr - sine * qr;
    aqr[i] = cosine * qr + sine * pr;
    const float px = p.x[i], py = p.y[i], pz = p.z[i];
    const float qx = q.x[i], qy = q.y[i], qz = q.z[i];
    p.x[i] = cosine * px - sine * qx;
    q.x[i] = cosine * qx + sine * px;
    p.y[i] = cosine * py - sine * qy;
    q.y[i] = cosine * qy + sine * py;
    p.z[i] = cosine * pz - sine * qz;
    q.z[i] = cosine * qz + sine * pz;
  }
}

/** \brief The eigenvectors of the smallest eigenvalues; NaN if two of the three vanish:
 * a single direction has no normal. */
inline void
smallest(Tensors& t, NormalBlock& out)
{
  Vectors u, v, w;
  float traces[block];
  for (int i = 0; i < block; ++i) {
    const float trace = (t.xx[i] + t.yy[i]) + t.zz[i];
    const float scale = 1 / (trace > 0 ? trace : 1);
    traces[i] = trace;
    t.xx[i] *= scale;
    t.xy[i] *= scale;
    t.xz[i] *= scale;
    t.yy[i] *= scale;
    t.yz[i] *= scale;
    t.zz[i] *= scale;
    u.x[i] = v.y[i] = w.z[i] = 1;
    u.y[i] = u.z[i] = v.x[i] = v.z[i] = w.x[i] = w.y[i] = 0;
  }
  for (int turn = 0; turn < 4; ++turn) {
    rotate(t.xx, t.yy, t.xy, t.xz, t.yz, u, v);
    rotate(t.xx, t.zz, t.xz, t.xy, t.yz, u, w);
    rotate(t.yy, t.zz, t.yz, t.xy, t.xz, v, w);
  }
  for (int i = 0; i < block; ++i) {
    const float xx = t.xx[i], yy = t.yy[i], zz = t.zz[i];
    const bool by_y = yy < xx;
    float least = by_y ? yy : xx;
    float nx = by_y ? v.x[i] : u.x[i];
    float ny = by_y ? v.y[i] : u.y[i];
    float nz = by_y ? v.z[i] : u.z[i];
    const bool by_z = zz < least;
    least = by_z ? zz : least;
    nx = by_z ? w.x[i] : nx;
    ny = by_z ? w.y[i] : ny;
    nz = by_z ? w.z[i] : nz;
    const float more = xx > yy ? xx : yy, most = more > zz ? more : zz;
    constexpr float nothing = 1e-6F;
    const bool known = (traces[i] > 0) & (1 - most - least > nothing);
    out.x[i] = known ? nx : unknown;
    out.y[i] = known ? ny : unknown;
    out.z[i] = known ? nz : unknown;
  }
}

inline void
tensorNormals(
    const PaddedSamples& s, int rings, float limit, std::ptrdiff_t at, NormalBlock& out)
{
  // The pixel's own samples differ from their mean along the ray, and would only tilt
  // the plane toward it.
  Tensors t = {};
  for (int ring = 0; ring < rings; ++ring)
    for (const auto& place : ring_places[ring])
      for (int layer = 0; layer < s.layers; ++layer) {
        const std::ptrdiff_t from =
            layer * s.layer + at + place[1] * s.stride + place[0];
        addDirections(s.x.data() + from,
                      s.y.data() + from,
                      s.z.data() + from,
                      s.cx.data() + at,
                      s.cy.data() + at,
                      s.cz.data() + at,
                      limit,
                      t);
      }
  smallest(t, out);
}

} // namespace HWY_NAMESPACE
} // namespace linelet::screen
HWY_AFTER_NAMESPACE();

#endif
