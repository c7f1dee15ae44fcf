// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sums of moments up to the fourth. Included once per instruction set, so it has a
// guard that toggles.

#if defined(LINELET_GRID_QUADRATIC_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_QUADRATIC_INL
#undef LINELET_GRID_QUADRATIC_INL
#else
#define LINELET_GRID_QUADRATIC_INL
#endif

#include <hwy/highway.h>

#include "sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

/** \brief Different products of coordinates, and those of two with |p|^2, of a chunk.
 */
struct ProductSums {
  V x, y, z, xx, xy, xz, yy, yz, zz;
  V xxx, xxy, xxz, xyy, xyz, xzz, yyy, yyz, yzz, zzz;
  V sxx, sxy, sxz, syy, syz, szz;

  HWY_INLINE
  ProductSums()
  {
    x = y = z = xx = xy = xz = yy = yz = zz = hn::Zero(F());
    xxx = xxy = xxz = xyy = xyz = xzz = yyy = yyz = yzz = zzz = x;
    sxx = sxy = sxz = syy = syz = szz = x;
  }

  HWY_INLINE void
  add(V px, V py, V pz)
  {
    const V pxx = hn::Mul(px, px), pxy = hn::Mul(px, py), pxz = hn::Mul(px, pz),
            pyy = hn::Mul(py, py), pyz = hn::Mul(py, pz), pzz = hn::Mul(pz, pz);
    const V square = hn::Add(pxx, hn::Add(pyy, pzz));
    x = hn::Add(x, px);
    y = hn::Add(y, py);
    z = hn::Add(z, pz);
    const auto sum = [&](V& second, V& fourth, V product) HWY_ATTR {
      second = hn::Add(second, product);
      fourth = hn::MulAdd(square, product, fourth);
    };
    sum(xx, sxx, pxx);
    sum(xy, sxy, pxy);
    sum(xz, sxz, pxz);
    sum(yy, syy, pyy);
    sum(yz, syz, pyz);
    sum(zz, szz, pzz);
    xxx = hn::MulAdd(px, pxx, xxx);
    xxy = hn::MulAdd(px, pxy, xxy);
    xxz = hn::MulAdd(px, pxz, xxz);
    xyy = hn::MulAdd(px, pyy, xyy);
    xyz = hn::MulAdd(px, pyz, xyz);
    xzz = hn::MulAdd(px, pzz, xzz);
    yyy = hn::MulAdd(py, pyy, yyy);
    yyz = hn::MulAdd(py, pyz, yyz);
    yzz = hn::MulAdd(py, pzz, yzz);
    zzz = hn::MulAdd(pz, pzz, zzz);
  }

  /** \brief As the moments of \a count points. */
  HWY_INLINE QuadraticMoments
  moments(std::size_t count) const
  {
    const auto of = [](double weight, Point first, V a, V b, V c, V d, V e, V g)
                        HWY_ATTR {
                          Moments m;
                          m.count = weight;
                          m.first = first;
                          m.xx = sumOf(a);
                          m.xy = sumOf(b);
                          m.xz = sumOf(c);
                          m.yy = sumOf(d);
                          m.yz = sumOf(e);
                          m.zz = sumOf(g);
                          return m;
                        };
    QuadraticMoments m;
    m.one = of(static_cast<double>(count),
               {sumOf(x), sumOf(y), sumOf(z)},
               xx,
               xy,
               xz,
               yy,
               yz,
               zz);
    const Moments& one = m.one;
    m.x = of(one.first.x(), {one.xx, one.xy, one.xz}, xxx, xxy, xxz, xyy, xyz, xzz);
    m.y = of(one.first.y(), {one.xy, one.yy, one.yz}, xxy, xyy, xyz, yyy, yyz, yzz);
    m.z = of(one.first.z(), {one.xz, one.yz, one.zz}, xxz, xyz, xzz, yyz, yzz, zzz);
    m.square = of(one.trace(),
                  {m.x.trace(), m.y.trace(), m.z.trace()},
                  sxx,
                  sxy,
                  sxz,
                  syy,
                  syz,
                  szz);
    return m;
  }
};

void
quadraticMoments(const PointList& list,
                 std::size_t begin,
                 const Float3& center,
                 QuadraticMoments& sums)
{
  const F f;
  const std::size_t lanes = hn::Lanes(f);
  const V cx = constant(center[0]), cy = constant(center[1]), cz = constant(center[2]);
  for (std::size_t chunk = begin; chunk < list.size; chunk += chunk_vectors * lanes) {
    const std::size_t end = HWY_MIN(chunk + chunk_vectors * lanes, list.size);
    ProductSums part;
    for (std::size_t i = chunk; i < end; i += lanes) {
      // The list may lack padding; at the center a point adds nothing.
      const auto real = hn::FirstN(f, end - i);
      const auto relative = [&](const float* values, V c) HWY_ATTR {
        return hn::IfThenElseZero(real, hn::Sub(hn::LoadU(f, values + i), c));
      };
      part.add(relative(list.x, cx), relative(list.y, cy), relative(list.z, cz));
    }
    sums += part.moments(end - chunk);
  }
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
