// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the kernels have for every pixel of a block. Included once per instruction
// set, so it has a guard that toggles.

#if defined(LINELET_SCREEN_PIXEL_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_SCREEN_PIXEL_LANES_INL
#undef LINELET_SCREEN_PIXEL_LANES_INL
#else
#define LINELET_SCREEN_PIXEL_LANES_INL
#endif

#include <cstddef>
#include <limits>

#include <hwy/highway.h>

#include "normal_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::screen {
namespace HWY_NAMESPACE {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

/** \brief A vector of every pixel of a block. */
struct Vectors {
  float x[block], y[block], z[block];
};

/** \brief Places of a block. */
struct Places {
  Places(const float* px, const float* py, const float* pz, std::ptrdiff_t from)
      : x(px + from), y(py + from), z(pz + from)
  {
  }

  const float *HWY_RESTRICT x, *HWY_RESTRICT y, *HWY_RESTRICT z;
};

} // namespace HWY_NAMESPACE
} // namespace linelet::screen
HWY_AFTER_NAMESPACE();

#endif
