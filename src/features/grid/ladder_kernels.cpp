// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ladder_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "features/grid/ladder_kernels.cpp"
#include <hwy/foreach_target.h> // includes this file once per instruction set

#include <hwy/highway.h>

#include "ladder_lists-inl.h"
#include "ladder_pairs-inl.h"
#include "ladder_shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

LadderKernels
ladder()
{
  return {splitGroups,
          placeGroup,
          openGroups,
          order,
          coincident,
          constPairs,
          weightedPairs,
          centredPairs,
          finish,
          factors};
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace linelet::grid {

HWY_EXPORT(ladder);

LadderKernels
ladderKernels()
{
  return HWY_DYNAMIC_DISPATCH(ladder)();
}

} // namespace linelet::grid

#endif
