// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Included once per instruction set, so it has a guard that toggles.

#if defined(LINELET_CURVES_QUICK_EXP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_CURVES_QUICK_EXP_INL
#undef LINELET_CURVES_QUICK_EXP_INL
#else
#define LINELET_CURVES_QUICK_EXP_INL
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linelet {
namespace HWY_NAMESPACE {

/** \brief exp(x) with a relative error of 3e-9, for x from -708 to 709: enough for
 * densities, at a third of the cost of full precision. */
template <class D, class V = hwy::HWY_NAMESPACE::Vec<D>>
HWY_INLINE V
quickExp(D d, V x)
{
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::RebindToSigned<D> integers;
  // exp(x) = 2^n exp(r), |r| <= log(2) / 2; adding 1.5 * 2^52 rounds and leaves n in
  // the last bits.
  const V shift = hn::Set(d, 6755399441055744.0);
  const V shifted = hn::MulAdd(x, hn::Set(d, 1.4426950408889634), shift);
  const V r = hn::NegMulAdd(hn::Sub(shifted, shift), hn::Set(d, 0.6931471805599453), x);
  V power = hn::Set(d, 0.0013941108435501846);
  for (const double c : {0.008375126398156,
                         0.04166635289675798,
                         0.16666415514653268,
                         0.5000000047117756,
                         1.0000000377162137,
                         1.0})
    power = hn::MulAdd(power, r, hn::Set(d, c));
  const auto exponent = hn::ShiftLeft<52>(hn::BitCast(integers, shifted));
  return hn::BitCast(d, hn::Add(hn::BitCast(integers, power), exponent));
}

} // namespace HWY_NAMESPACE
} // namespace linelet
HWY_AFTER_NAMESPACE();

#endif
