// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Weighting kernels of u = x^2 on vectors of floats. Included once per instruction set,
// so it has a guard that toggles.

#if defined(LINELET_GRID_WEIGHTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_WEIGHTS_INL
#undef LINELET_GRID_WEIGHTS_INL
#else
#define LINELET_GRID_WEIGHTS_INL
#endif

#include <type_traits>

#include <hwy/highway.h>

#include <linelet/tensor/weighting.h>

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using F = hn::ScalableTag<float>;
using V = hn::Vec<F>;

HWY_INLINE V
constant(float value)
{
  return hn::Set(F(), value);
}

/** \brief c0 + c1 x + c2 x^2 + ... */
template <class... More>
HWY_INLINE V
polynomial(V x, float c0, More... more)
{
  if constexpr (sizeof...(More) == 0) {
    (void)x;
    return constant(c0);
  }
  else
    return hn::MulAdd(polynomial(x, more...), x, constant(c0));
}

template <int exponent>
HWY_INLINE V
power(V x)
{
  if constexpr (exponent == 1)
    return x;
  else {
    const V half = power<exponent / 2>(x);
    const V square = hn::Mul(half, half);
    if constexpr (exponent % 2 == 1)
      return hn::Mul(square, x);
    else
      return square;
  }
}

/** \brief 2^y for y in [-126, 126], relative error below 2.5e-7: the integer part goes
 * into the exponent, the rest, in [-1/2, 1/2], through a minimax polynomial. */
HWY_INLINE V
exp2Of(V y)
{
  const F f;
  const hn::RebindToSigned<F> i;
  // Adding 1.5 * 2^23 leaves the rounded integer in the low bits.
  const V magic = constant(12582912.0F);
  const V shifted = hn::Add(y, magic);
  const V rest = hn::Sub(y, hn::Sub(shifted, magic));
  const V p = polynomial(rest,
                         1.000000072F,
                         0.6931469671F,
                         0.2402211972F,
                         0.05550713274F,
                         0.009675541334F,
                         0.001327647198F);
  const auto exponent = hn::ShiftLeft<23>(hn::BitCast(i, shifted));
  return hn::BitCast(f, hn::Add(hn::BitCast(i, p), exponent));
}

/** \brief sin(pi t) for |t| up to 2^20, absolute error below 3e-7. */
HWY_INLINE V
sinPi(V t)
{
  const F f;
  const hn::RebindToSigned<F> i;
  const V magic = constant(12582912.0F);
  const V shifted = hn::Add(t, magic);
  const V rest = hn::Sub(t, hn::Sub(shifted, magic)); // exact, in [-1/2, 1/2]
  const V s = hn::Mul(rest, rest);
  const V sine = hn::Mul(
      rest,
      polynomial(
          s, 3.14159258F, -5.167706879F, 2.550031377F, -0.5980451742F, 0.07722012906F));
  const auto odd = hn::ShiftLeft<31>(hn::BitCast(i, shifted));
  return hn::Xor(sine, hn::BitCast(f, odd));
}

HWY_INLINE V
bounce(V x)
{
  const V last = polynomial(x, 268.0F / 25, -513.0F / 25, 54.0F / 5);
  const V third = polynomial(x, 16061.0F / 1805, -35442.0F / 1805, 4356.0F / 361);
  const V second = polynomial(x, 17.0F / 5, -99.0F / 10, 363.0F / 40);
  const V first = hn::Mul(constant(121.0F / 16), hn::Mul(x, x));
  V b = hn::IfThenElse(hn::Lt(x, constant(0.9F)), third, last);
  b = hn::IfThenElse(hn::Lt(x, constant(8.0F / 11)), second, b);
  return hn::IfThenElse(hn::Lt(x, constant(4.0F / 11)), first, b);
}

/** \brief max(0, end - s)^exponent, what B-splines are sums of. */
template <int exponent>
HWY_INLINE V
truncated(float end, V s)
{
  return power<exponent>(hn::Max(hn::Zero(F()), hn::Sub(constant(end), s)));
}

/** \brief An easing curve of x in [0, 1) is symmetric about (1/2, 1/2): 1 - curve(x) is
 * 1 - half(x) in the first half and half(1 - x) in the second. */
template <class Half>
HWY_INLINE V
eased(V x, const Half& half)
{
  const V one = constant(1);
  const auto first = hn::Lt(x, constant(0.5F));
  const V h = half(hn::IfThenElse(first, x, hn::Sub(one, x)));
  return hn::IfThenElse(first, hn::Sub(one, h), h);
}

/** \brief w of a kernel as a functor of u; compact ones are wrong beyond u = 1 here. */
template <Kernel kernel>
struct Weight {
  explicit Weight(const Weighting& weighting)
  {
    const auto [m, t] = weighting.parameters();
    if (t > 0) {
      constexpr double log2_e = 1.4426950408889634;
      slope = static_cast<float>(log2_e / t);
      offset = static_cast<float>(-m / t * log2_e);
    }
  }

  HWY_INLINE V
  operator()(V u) const
  {
    const V one = constant(1);
    if constexpr (kernel == Kernel::Const)
      return one;
    else if constexpr (kernel == Kernel::Quadratic)
      return hn::Sub(one, u);
    else if constexpr (kernel == Kernel::Epanechnikov)
      return hn::NegMulAdd(constant(0.75F), u, constant(0.75F));
    else if constexpr (kernel == Kernel::QuadraticInverse)
      return hn::Min(one, hn::Div(constant(0.01F), u));
    else if constexpr (kernel == Kernel::InverseSquaredDistance)
      return hn::IfThenElseZero(hn::Gt(u, hn::Zero(F())), hn::Div(one, u));
    else if constexpr (kernel == Kernel::EaseCircular)
      return circular(u, hn::Sqrt(u));
    else
      return ofRoot(hn::Sqrt(u));
  }

  HWY_INLINE V
  ofRoot(V x) const
  {
    const V one = constant(1);
    const V y = hn::Sub(one, x);
    const auto quadratic = [](V v, float c1, float c2)
                               HWY_ATTR { return polynomial(v, 1.0F, c1, c2); };
    if constexpr (kernel == Kernel::FermiDirac) {
      // Held where exp2 is defined; there w is 1 or 0 to the last bit.
      V e = hn::MulAdd(x, constant(slope), constant(offset));
      e = hn::Min(hn::Max(e, constant(-126)), constant(126));
      return hn::Div(one, hn::Add(one, exp2Of(e)));
    }
    else if constexpr (kernel == Kernel::LinearInverse)
      return hn::Min(one, hn::Div(constant(0.1F), x));
    else if constexpr (kernel == Kernel::InverseDistance)
      return hn::IfThenElseZero(hn::Gt(x, hn::Zero(F())), hn::Div(one, x));
    else if constexpr (kernel == Kernel::CubicInverse)
      return hn::Min(one, power<3>(hn::Div(constant(0.1F), x)));
    else if constexpr (kernel == Kernel::Linear || kernel == Kernel::CsRbf1)
      return y;
    else if constexpr (kernel == Kernel::Cubic) // 1 - x^3
      return hn::Mul(y, quadratic(x, 1, 1));
    else if constexpr (kernel == Kernel::Sph3) {
      // With a = 2x: 1/4 (2-a)_+^3 - (1-a)_+^3.
      const V a = hn::Add(x, x);
      return hn::NegMulAdd(
          one, truncated<3>(1, a), hn::Mul(constant(0.25F), truncated<3>(2, a)));
    }
    else if constexpr (kernel == Kernel::Sph4) {
      const V b = hn::Mul(constant(2.5F), x);
      const V s =
          hn::NegMulAdd(constant(5), truncated<4>(1.5F, b), truncated<4>(2.5F, b));
      return hn::MulAdd(constant(10), truncated<4>(0.5F, b), s);
    }
    else if constexpr (kernel == Kernel::Sph5) {
      const V c = hn::Mul(constant(3), x);
      const V s = hn::NegMulAdd(constant(6), truncated<5>(2, c), truncated<5>(3, c));
      // The sum of all three for c < 1, without its cancellation.
      const V inner = polynomial(c, 66.0F, 0.0F, -60.0F, 0.0F, 30.0F, -10.0F);
      return hn::IfThenElse(hn::Lt(c, one), inner, s);
    }
    else if constexpr (kernel == Kernel::CsRbf2)
      return hn::Mul(power<3>(y), polynomial(x, 1.0F, 3.0F));
    else if constexpr (kernel == Kernel::CsRbf3)
      return hn::Mul(power<5>(y), polynomial(x, 1.0F, 5.0F, 8.0F));
    else if constexpr (kernel == Kernel::CsRbf4)
      return power<2>(y);
    else if constexpr (kernel == Kernel::CsRbf5)
      return hn::Mul(power<4>(y), polynomial(x, 1.0F, 4.0F));
    else if constexpr (kernel == Kernel::CsRbf6)
      return hn::Mul(power<6>(y), polynomial(x, 3.0F, 18.0F, 35.0F));
    else if constexpr (kernel == Kernel::CsRbf7)
      return hn::Mul(power<8>(y), polynomial(x, 1.0F, 8.0F, 25.0F, 32.0F));
    else if constexpr (kernel == Kernel::CsRbf8)
      return power<3>(y);
    else if constexpr (kernel == Kernel::CsRbf9)
      return hn::Mul(power<3>(y), polynomial(x, 1.0F, 5.0F));
    else if constexpr (kernel == Kernel::CsRbf10)
      return hn::Mul(power<7>(y), polynomial(x, 1.0F, 7.0F, 16.0F));
    else
      return easing(x);
  }

  HWY_INLINE V
  easing(V x) const
  {
    const V one = constant(1), half = constant(0.5F);
    if constexpr (kernel == Kernel::EaseBounce)
      return eased(x, [&](V s) HWY_ATTR {
        return hn::Mul(half, hn::Sub(one, bounce(hn::NegMulAdd(constant(2), s, one))));
      });
    else if constexpr (kernel == Kernel::EaseCircular)
      return circular(hn::Mul(x, x), x);
    else if constexpr (kernel == Kernel::EaseElastic)
      return eased(x, [&](V s) HWY_ATTR {
        const V amplitude = exp2Of(polynomial(s, -11.0F, 20.0F));
        return hn::Mul(amplitude, sinPi(hn::Mul(constant(13), s)));
      });
    else if constexpr (kernel == Kernel::EaseExponential)
      // At 0 the curve has a step from 0 to 2^-11, and its mirror at 1.
      return hn::IfThenElse(hn::Eq(x, hn::Zero(F())), one, eased(x, [&](V s) HWY_ATTR {
                              return exp2Of(polynomial(s, -11.0F, 20.0F));
                            }));
    else if constexpr (kernel == Kernel::EaseSine)
      // (1 - cos(pi s)) / 2 = sin^2(pi s / 2)
      return eased(x, [&](V s) HWY_ATTR { return power<2>(sinPi(hn::Mul(half, s))); });
    else if constexpr (kernel == Kernel::EaseCubic)
      return eased(x, [&](V s) HWY_ATTR { return hn::Mul(constant(4), power<3>(s)); });
    else if constexpr (kernel == Kernel::EaseQuadratic)
      return eased(x, [&](V s) HWY_ATTR { return hn::Mul(constant(2), power<2>(s)); });
    else {
      static_assert(kernel == Kernel::EaseQuintic, "a kernel without a SIMD form");
      return eased(x, [&](V s) HWY_ATTR { return hn::Mul(constant(16), power<5>(s)); });
    }
  }

  /** \brief (1 - sqrt(1 - 4 s^2)) / 2 of the halves, without the cancellation. At s =
   * 1/2 it is steep: 1 - 4 s^2 follows from u, not from its rounded root. */
  static HWY_INLINE V
  circular(V u, V x)
  {
    const V one = constant(1);
    const V rest = hn::NegMulAdd(constant(4), u, one);
    const V twice = hn::Add(x, x);
    // With s = 1 - x: (2x - 1) (3 - 2x).
    const V mirrored =
        hn::Div(hn::Mul(rest, hn::Sub(twice, constant(3))), hn::Add(twice, one));
    return eased(x, [&](V s) HWY_ATTR {
      const V inner = hn::IfThenElse(hn::Lt(x, constant(0.5F)), rest, mirrored);
      const V root = hn::Sqrt(hn::Max(hn::Zero(F()), inner));
      const V square = hn::Mul(s, s);
      return hn::Div(hn::Add(square, square), hn::Add(one, root));
    });
  }

  float slope = 0, offset = 0; // of the Fermi-Dirac exponent, to base 2
};

/** \brief 1 up to S. Rounding decides at S itself: the caller must look there. */
template <>
struct Weight<Kernel::Step> {
  explicit Weight(const Weighting& weighting)
      : end(static_cast<float>(weighting.parameters()[0] * weighting.parameters()[0]))
  {
  }

  HWY_INLINE V
  operator()(V u) const
  {
    return hn::IfThenElseZero(hn::Le(u, constant(end)), constant(1));
  }

  float end;
};

/** \brief w of u anywhere, never negative. */
template <Kernel kernel>
struct ClampedWeight : Weight<kernel> {
  using Weight<kernel>::Weight;

  HWY_INLINE V
  operator()(V u) const
  {
    const V w = Weight<kernel>::operator()(u);
    if constexpr (supportOf(kernel) == KernelSupport::Everywhere)
      return w;
    else if constexpr (kernel == Kernel::EaseElastic || kernel == Kernel::EaseBounce)
      return hn::IfThenElseZero(hn::Lt(u, constant(1)), hn::Max(w, hn::Zero(F())));
    else
      return hn::IfThenElseZero(hn::Lt(u, constant(1)), w);
  }
};

/** \brief All Fermi-Dirac kernels share one functor. */
constexpr Kernel
vectorForm(Kernel kernel)
{
  return kernel == Kernel::FermiDirac1 || kernel == Kernel::FermiDirac2 ||
                 kernel == Kernel::FermiDirac3
             ? Kernel::FermiDirac
             : kernel;
}

/** \brief Calls act(kernel) with the kernel of \a weighting as an integral constant. */
template <class Act>
HWY_INLINE void
withKernel(const Weighting& weighting, const Act& act)
{
  switch (weighting.kernel()) {
#define LINELET_KERNEL(kernel, name, support, weight)                                  \
  case Kernel::kernel:                                                                 \
    return act(std::integral_constant<Kernel, vectorForm(Kernel::kernel)>());
    LINELET_KERNELS(LINELET_KERNEL)
#undef LINELET_KERNEL
  }
}

/** \brief Calls act(functor) with the functor of \a weighting. */
template <class Act>
HWY_INLINE void
withWeight(const Weighting& weighting, const Act& act)
{
  withKernel(weighting, [&](auto kernel) HWY_ATTR {
    act(ClampedWeight<decltype(kernel)::value>(weighting));
  });
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
