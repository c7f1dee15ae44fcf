// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Moments of neighborhoods, a query per lane. Included once per instruction set,
// so it has a guard that toggles.

#if defined(LINELET_GRID_LANE_MOMENTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_LANE_MOMENTS_INL
#undef LINELET_GRID_LANE_MOMENTS_INL
#else
#define LINELET_GRID_LANE_MOMENTS_INL
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<double>;
using VD = hn::Vec<D>;

/** \brief Moments in double, a query per lane. */
struct LaneMoments {
  VD total, x, y, z, xx, xy, xz, yy, yz, zz;

  /** \brief The same sums about o. */
  HWY_INLINE void
  moveTo(VD ox, VD oy, VD oz)
  {
    const auto square = [&](VD& s, VD o, VD first) HWY_ATTR {
      s = hn::MulAdd(o, hn::NegMulAdd(hn::Set(D(), 2), first, hn::Mul(total, o)), s);
    };
    const auto mixed = [&](VD& s, VD a, VD b, VD first_a, VD first_b) HWY_ATTR {
      s = hn::NegMulAdd(first_a, b, hn::NegMulAdd(first_b, a, s));
      s = hn::MulAdd(total, hn::Mul(a, b), s);
    };
    square(xx, ox, x);
    square(yy, oy, y);
    square(zz, oz, z);
    mixed(xy, ox, oy, x, y);
    mixed(xz, ox, oz, x, z);
    mixed(yz, oy, oz, y, z);
    x = hn::NegMulAdd(total, ox, x);
    y = hn::NegMulAdd(total, oy, y);
    z = hn::NegMulAdd(total, oz, z);
  }

  HWY_INLINE VD
  trace() const
  {
    return hn::Add(xx, hn::Add(yy, zz));
  }
};

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
