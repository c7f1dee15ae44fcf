// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Weighting kernels of squared distances on vectors of floats, by tables where they are
// faster. Included once per instruction set, so it has a guard that toggles.

#if defined(LINELET_GRID_TABLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_TABLE_INL
#undef LINELET_GRID_TABLE_INL
#else
#define LINELET_GRID_TABLE_INL
#endif

#include <hwy/highway.h>

#include "weight_table.h"
#include "weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

/** \brief The functions themselves, of squared distance. */
template <Kernel kernel>
class DirectWeight {
public:
  DirectWeight(const Weighting& weighting, float scale)
      : weight_(weighting), scale_(constant(scale))
  {
  }

  HWY_INLINE V
  operator()(V squared) const
  {
    return weight_(hn::Mul(squared, scale_));
  }

  /** \brief Where no point is near. */
  HWY_INLINE V
  far(V squared) const
  {
    return (*this)(squared);
  }

private:
  ClampedWeight<kernel> weight_;
  V scale_;
};

#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3

/** \brief A WeightTable in registers, two of which hold a coefficient of all intervals.
 * \tparam unit: the scale is 1 */
template <Kernel kernel, int degree, bool unit>
class TableWeight {
public:
  TableWeight(const SweepWeight& weight, float scale)
      : direct_(weight.weighting, scale),
        scale_(constant(scale)),
        from_(constant(weight.table.from / scale))
  {
    const F f;
    for (std::size_t i = 0; i <= degree; ++i) {
      low_[i] = hn::LoadU(f, weight.table.coefficients[i].data());
      high_[i] = hn::LoadU(f, weight.table.coefficients[i].data() + 16);
    }
  }

  HWY_INLINE V
  operator()(V squared) const
  {
    const V w = far(squared);
    const auto near = hn::Lt(squared, from_);
    if (HWY_LIKELY(hn::AllFalse(F(), near)))
      return w;
    return hn::IfThenElse(near, direct_(squared), w);
  }

  HWY_INLINE V
  far(V squared) const
  {
    // Relative to the middle of the first interval, so that rounding to whole intervals
    // leaves the number of the interval in the low bits (the permutation uses no
    // others) and the position within it as the rest.
    const V middle = constant(0.5F / WeightTable::intervals);
    const V place =
        unit ? hn::Sub(squared, middle) : hn::MulSub(squared, scale_, middle);
    const V magic = constant(12582912.0F / WeightTable::intervals);
    const V shifted = hn::Add(place, magic);
    const V t = hn::Sub(place, hn::Sub(shifted, magic));
    const __m512i interval = _mm512_castps_si512(shifted.raw);
    V w = coefficient(degree, interval);
    for (int i = degree - 1; i >= 0; --i)
      w = hn::MulAdd(w, t, coefficient(i, interval));
    return w;
  }

private:
  HWY_INLINE V
  coefficient(int i, __m512i interval) const
  {
    return V{_mm512_permutex2var_ps(low_[i].raw, interval, high_[i].raw)};
  }

  DirectWeight<kernel> direct_;
  V scale_, from_;
  V low_[degree + 1], high_[degree + 1];
};

/** \brief Calls act(functor) with the table of \a weight; false if it has none. */
template <class Act>
HWY_INLINE bool
withTableOnly(const SweepWeight& weight, float scale, const Act& act)
{
  static_assert(WeightTable::intervals == 32 && WeightTable::least_degree == 3 &&
                WeightTable::most_degree == 5);
  const bool unit = scale == 1;
  switch (weight.table.degree) {
  case 3:
    unit ? act(TableWeight<Kernel::FermiDirac, 3, true>(weight, scale))
         : act(TableWeight<Kernel::FermiDirac, 3, false>(weight, scale));
    return true;
  case 4:
    act(TableWeight<Kernel::FermiDirac, 4, false>(weight, scale));
    return true;
  case 5:
    act(TableWeight<Kernel::FermiDirac, 5, false>(weight, scale));
    return true;
  default:
    return false;
  }
}

#else

template <class Act>
HWY_INLINE bool
withTableOnly(const SweepWeight&, float, const Act&)
{
  return false;
}

#endif

/** \brief Calls act(functor) with a functor of squared distance for \a weight of the
 * square times \a scale. */
template <class Act>
HWY_INLINE void
withTable(const SweepWeight& weight, float scale, const Act& act)
{
  if (!withTableOnly(weight, scale, act))
    withKernel(weight.weighting, [&](auto kernel) HWY_ATTR {
      act(DirectWeight<decltype(kernel)::value>(weight.weighting, scale));
    });
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
