// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "multi_scale_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "features/simd_grid/kernels/multi_scale_kernels.cpp"
#include <hwy/foreach_target.h> // includes this file once per instruction set

#include <hwy/highway.h>

#include "multi_scale_lists-inl.h"
#include "multi_scale_pairs-inl.h"
#include "multi_scale_shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

MultiScaleKernels
multi_scale()
{
  return {splitGroups,
          placeGroup,
          openGroups,
          order,
          coincident,
          constPairs,
          weightedPairs,
          centeredPairs,
          finish,
          factors};
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace linelet::grid {

HWY_EXPORT(multi_scale);

MultiScaleKernels
multiScaleKernels()
{
  return HWY_DYNAMIC_DISPATCH(multi_scale)();
}

} // namespace linelet::grid

#endif
