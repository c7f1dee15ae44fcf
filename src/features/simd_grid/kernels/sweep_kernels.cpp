// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "sweep_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "features/simd_grid/kernels/sweep_kernels.cpp"
#include <hwy/foreach_target.h> // includes this file once per instruction set

#include <hwy/highway.h>

#include "eigen-inl.h"
#include "lists-inl.h"
#include "quadratic-inl.h"
#include "records-inl.h"
#include "sums-inl.h"
#include "table-inl.h"
#include "weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

void
weights(const SweepWeight& weight,
        bool table,
        const float* squared,
        float* values,
        std::size_t count)
{
  const F f;
  const auto evaluate = [&](const auto& w) HWY_ATTR {
    for (std::size_t i = 0; i < count; i += hn::Lanes(f))
      hn::StoreU(w(hn::LoadU(f, squared + i)), f, values + i);
  };
  if (table)
    withTable(weight, 1, evaluate);
  else
    withWeight(weight.weighting, evaluate);
}

SweepKernels
kernels()
{
  return {hwy::TargetName(HWY_TARGET),
          hn::Lanes(F()),
          gather,
          classify,
          split,
          constSums,
          weightedSums,
          quadraticMoments,
          momentsAround,
          neighbors,
          inBand,
          weights,
          records,
          eigen};
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace linelet::grid {

HWY_EXPORT(kernels);

SweepKernels
sweepKernels()
{
  return HWY_DYNAMIC_DISPATCH(kernels)();
}

} // namespace linelet::grid

#endif
