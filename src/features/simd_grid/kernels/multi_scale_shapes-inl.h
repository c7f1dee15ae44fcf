// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From sums of moments to shape factors, a query per lane. Included once per
// instruction set, so it has a guard that toggles.

#if defined(LINELET_GRID_MULTI_SCALE_SHAPES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_MULTI_SCALE_SHAPES_INL
#undef LINELET_GRID_MULTI_SCALE_SHAPES_INL
#else
#define LINELET_GRID_MULTI_SCALE_SHAPES_INL
#endif

#include <hwy/highway.h>

#include "lane_moments-inl.h"
#include "multi_scale_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

std::uint32_t
finish(const ShapeInput& work,
       std::array<Lanes<double>, 6>& tensors,
       Lanes<float>& found)
{
  const D d;
  const hn::Rebind<float, D> half;
  constexpr double wanted = 3e-5, rounding = 5e-7;
  const VD zero = hn::Zero(d);
  std::uint32_t good = 0;
  for (std::size_t q = 0; q < leaf_queries; q += hn::Lanes(d)) {
    const auto load = [&](Moment m, double inside) HWY_ATTR {
      return hn::Add(hn::Load(d, work.sums.sum[m].lane + q), hn::Set(d, inside));
    };
    const Moments none;
    const Moments& inside = work.inside != nullptr ? *work.inside : none;
    LaneMoments m{load(Total, inside.count),
                  load(X, inside.first.x()),
                  load(Y, inside.first.y()),
                  load(Z, inside.first.z()),
                  load(XX, inside.xx),
                  load(XY, inside.xy),
                  load(XZ, inside.xz),
                  load(YY, inside.yy),
                  load(YZ, inside.yz),
                  load(ZZ, inside.zz)};
    const VD spread = m.trace();
    if (work.inside != nullptr)
      hn::Store(hn::DemoteTo(half, m.total), half, found.lane + q);
    else
      hn::Store(hn::Load(half, work.sums.found.lane + q), half, found.lane + q);
    const VD count = hn::PromoteTo(d, hn::Load(half, found.lane + q));
    const VD inverse =
        hn::IfThenElseZero(hn::Gt(m.total, zero), hn::Div(hn::Set(d, 1), m.total));
    if (!work.relative && work.reference == Reference::Query)
      m.moveTo(hn::Load(d, work.query[0].lane + q),
               hn::Load(d, work.query[1].lane + q),
               hn::Load(d, work.query[2].lane + q));
    else if (work.reference == Reference::Mean)
      m.moveTo(hn::Mul(m.x, inverse), hn::Mul(m.y, inverse), hn::Mul(m.z, inverse));

    const VD trace = m.trace();
    // Errors of single weights are rounding, and add up as such.
    const VD weights = hn::MulAdd(hn::Set(d, 4 * work.weight_absolute),
                                  hn::Sqrt(count),
                                  hn::Mul(hn::Set(d, work.weight_relative), trace));
    const VD coordinates = hn::Mul(hn::Set(d, work.coordinate_error),
                                   hn::Sqrt(hn::Max(zero, hn::Mul(m.total, trace))));
    const VD error =
        hn::Add(hn::MulAdd(hn::Set(d, rounding), spread, weights), coordinates);
    auto precise = hn::And(hn::Gt(trace, zero), hn::Gt(m.total, zero));
    precise = hn::And(precise, hn::Le(error, hn::Mul(hn::Set(d, wanted), trace)));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, precise, bits);
    good |= std::uint32_t{bits[0]} << q;

    hn::Store(hn::Mul(m.xx, inverse), d, tensors[0].lane + q);
    hn::Store(hn::Mul(m.xy, inverse), d, tensors[1].lane + q);
    hn::Store(hn::Mul(m.xz, inverse), d, tensors[2].lane + q);
    hn::Store(hn::Mul(m.yy, inverse), d, tensors[3].lane + q);
    hn::Store(hn::Mul(m.yz, inverse), d, tensors[4].lane + q);
    hn::Store(hn::Mul(m.zz, inverse), d, tensors[5].lane + q);
  }
  return good;
}

/** \brief c0 + c1 x + c2 x^2 + ... */
template <class... More>
HWY_INLINE VD
polynomial(VD x, double c0, More... more)
{
  const D d;
  if constexpr (sizeof...(More) == 0) {
    (void)x;
    return hn::Set(d, c0);
  }
  else
    return hn::MulAdd(polynomial(x, more...), x, hn::Set(d, c0));
}

void
factors(const std::array<Lanes<double>, 6>& tensors,
        Lanes<float>& linearity,
        Lanes<float>& planarity,
        Lanes<float>& sphericity)
{
  const D d;
  const hn::Rebind<float, D> half;
  const VD zero = hn::Zero(d), one = hn::Set(d, 1);
  for (std::size_t q = 0; q < leaf_queries; q += hn::Lanes(d)) {
    const auto load = [&](std::size_t entry)
                          HWY_ATTR { return hn::Load(d, tensors[entry].lane + q); };
    const VD xy = load(1), xz = load(2), yz = load(4);
    const VD mean =
        hn::Mul(hn::Add(load(0), hn::Add(load(3), load(5))), hn::Set(d, 1.0 / 3));
    // Eigenvalues of the deviator, p times those of a matrix with half determinant
    // cos(3 a), are 2 p cos of a and of a +- 2 pi / 3.
    const VD x = hn::Sub(load(0), mean), y = hn::Sub(load(3), mean),
             z = hn::Sub(load(5), mean);
    const VD xyxy = hn::Mul(xy, xy), xzxz = hn::Mul(xz, xz), yzyz = hn::Mul(yz, yz);
    const VD squares = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
    const VD mixed = hn::Add(xyxy, hn::Add(xzxz, yzyz));
    const VD pp =
        hn::Mul(hn::MulAdd(hn::Set(d, 2), mixed, squares), hn::Set(d, 1.0 / 6));
    const VD p = hn::Sqrt(pp);
    VD determinant = hn::Mul(x, hn::Sub(hn::Mul(y, z), yzyz));
    determinant = hn::NegMulAdd(xyxy, z, determinant);
    determinant = hn::NegMulAdd(xzxz, y, determinant);
    determinant = hn::MulAdd(hn::Mul(hn::Set(d, 2), xy), hn::Mul(xz, yz), determinant);
    const VD cube = hn::Mul(hn::Mul(hn::Set(d, 2), pp), p);
    VD r = hn::IfThenElseZero(hn::Gt(cube, zero), hn::Div(determinant, cube));
    r = hn::Max(hn::Set(d, -1), hn::Min(r, one));
    // With t = cos(3 a / 2), cos a and sin a / sin(3 a / 2) are smooth on [0, 1]: fits
    // at the Chebyshev nodes, off by 1.2e-11 and 1.5e-10.
    const VD t = hn::Sqrt(hn::Mul(hn::Add(one, r), hn::Set(d, 0.5)));
    const VD s = hn::Sqrt(hn::Mul(hn::Sub(one, r), hn::Set(d, 0.5)));
    const VD u = hn::Sub(hn::Add(t, t), one);
    const VD cosine = polynomial(u,
                                 0.7660444431275519,
                                 0.2474090663203198,
                                 -0.0155091890530544,
                                 0.00246635299750414,
                                 -0.0005041175434929989,
                                 0.0001164233379586932,
                                 -2.895003373870608e-05,
                                 7.549983142673965e-06,
                                 -1.979265684089645e-06,
                                 5.47411107258237e-07,
                                 -2.072221742347816e-07,
                                 5.994717848049427e-08);
    const VD sine = hn::Mul(s,
                            polynomial(u,
                                       0.7422271988651743,
                                       -0.09305513058574211,
                                       0.02219718276880658,
                                       -0.006049498678318777,
                                       0.001746295718214016,
                                       -0.0005205312393937362,
                                       0.0001587242968783542,
                                       -4.897689527065078e-05,
                                       1.455481511195937e-05,
                                       -4.568974862451114e-06,
                                       2.078646071860627e-06,
                                       -6.621482905681356e-07));
    constexpr double root3 = 1.7320508075688772;
    const VD scale = hn::Div(p, mean), side = hn::Mul(hn::Set(d, root3), sine);
    const VD cl =
        hn::Mul(hn::Mul(scale, hn::Set(d, 1.0 / 3)),
                hn::NegMulAdd(hn::Set(d, 1), side, hn::Mul(hn::Set(d, 3), cosine)));
    const VD cp = hn::Mul(hn::Mul(scale, hn::Set(d, 4.0 / 3)), side);
    const VD cs = hn::NegMulAdd(scale, hn::Add(cosine, side), one);
    const auto put = [&](VD value, Lanes<float>& to) HWY_ATTR {
      hn::Store(hn::DemoteTo(half, hn::Max(zero, value)), half, to.lane + q);
    };
    put(cl, linearity);
    put(cp, planarity);
    put(cs, sphericity);
  }
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
