// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plain loops over the pixels of a block, which the compiler turns into vectors of
// every instruction set. Nothing is fused or reordered: all sets give the same bits.

#include "normal_kernels.h"

#include <cmath>
#include <cstdlib>
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

/** \brief Coordinates of the axes of every pixel of a block. */
struct Axis {
  float x[block], y[block], z[block];
};

/** \brief Turns axes p and q so that the entry between them vanishes (Jacobi). */
inline void
rotate(float* HWY_RESTRICT app,
       float* HWY_RESTRICT aqq,
       float* HWY_RESTRICT apq,
       float* HWY_RESTRICT apr,
       float* HWY_RESTRICT aqr,
       Axis& HWY_RESTRICT p,
       Axis& HWY_RESTRICT q)
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

/** \brief The eigenvectors of the smallest eigenvalues; NaN where two of the three are
 * nothing: one direction alone has no normal. */
inline void
smallest(Tensors& t, NormalBlock& out)
{
  Axis u, v, w;
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

/** \brief Places of a block. */
struct Places {
  Places(const float* px, const float* py, const float* pz, std::ptrdiff_t from)
      : x(px + from), y(py + from), z(pz + from)
  {
  }

  const float *HWY_RESTRICT x, *HWY_RESTRICT y, *HWY_RESTRICT z;
};

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
  const auto own = [&](std::ptrdiff_t step) {
    return Places(s.cx.data(), s.cy.data(), s.cz.data(), at + step);
  };
  // Forwards, or backwards where that is missing.
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
  Axis first = {}, sum = {};
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

void
smooth(const PaddedSamples& s,
       const PaddedNormals& normals,
       float limit,
       int column,
       int row,
       PaddedNormals& out)
{
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::ScalableTag<float> floats;
  using Vector = hn::Vec<decltype(floats)>;
  struct Place {
    Vector x, y, z;
  };
  const auto load =
      [&](const auto& x, const auto& y, const auto& z, std::ptrdiff_t at) {
        return Place{hn::LoadU(floats, x.data() + at),
                     hn::LoadU(floats, y.data() + at),
                     hn::LoadU(floats, z.data() + at)};
      };
  const auto squareOf = [](const Place& p) {
    return hn::Add(hn::Add(hn::Mul(p.x, p.x), hn::Mul(p.y, p.y)), hn::Mul(p.z, p.z));
  };
  for (int i = 0; i < block; i += static_cast<int>(hn::Lanes(floats))) {
    const std::ptrdiff_t at = s.at(column, row) + i;
    const Place own = load(s.cx, s.cy, s.cz, at);
    Place sum = {hn::Zero(floats), hn::Zero(floats), hn::Zero(floats)};
    for (int down = -1; down <= 1; ++down)
      for (int right = -1; right <= 1; ++right) {
        const std::ptrdiff_t there = at + down * s.stride + right;
        const Place p = load(s.cx, s.cy, s.cz, there);
        const Place n = load(normals.x, normals.y, normals.z, there);
        const Place d = {hn::Sub(p.x, own.x), hn::Sub(p.y, own.y), hn::Sub(p.z, own.z)};
        const auto counts = hn::And(hn::Le(squareOf(d), hn::Set(floats, limit)),
                                    hn::Eq(n.x, n.x)); // not NaN
        // 4 in the middle, 2 beside, 1 at the corners.
        const Vector weight = hn::Set(
            floats, static_cast<float>((2 - std::abs(right)) * (2 - std::abs(down))));
        sum.x = hn::Add(sum.x, hn::IfThenElseZero(counts, hn::Mul(weight, n.x)));
        sum.y = hn::Add(sum.y, hn::IfThenElseZero(counts, hn::Mul(weight, n.y)));
        sum.z = hn::Add(sum.z, hn::IfThenElseZero(counts, hn::Mul(weight, n.z)));
      }
    const Place here = load(normals.x, normals.y, normals.z, at);
    const Vector length = hn::Sqrt(squareOf(sum));
    const auto known =
        hn::And(hn::Eq(here.x, here.x), hn::Gt(length, hn::Zero(floats)));
    const auto store = [&](Vector total, Vector before, float* to) {
      hn::StoreU(
          hn::IfThenElse(known, hn::Div(total, length), before), floats, to + at);
    };
    store(sum.x, here.x, out.x.data());
    store(sum.y, here.y, out.y.data());
    store(sum.z, here.z, out.z.data());
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
