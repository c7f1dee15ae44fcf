// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The weighted mean of the normals around a pixel. Included once per instruction
// set, so it has a guard that toggles.

#if defined(LINELET_SCREEN_SMOOTHING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_SCREEN_SMOOTHING_INL
#undef LINELET_SCREEN_SMOOTHING_INL
#else
#define LINELET_SCREEN_SMOOTHING_INL
#endif

#include <cstdlib>

#include <hwy/highway.h>

#include "normal_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::screen {
namespace HWY_NAMESPACE {

inline void
smooth(const PaddedSamples& s,
       const PaddedNormals& normals,
       float limit,
       int column,
       int row,
       PaddedNormals& out)
{
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::ScalableTag<float> floats;
  using Vector = hn::Vec<decltype(floats)>;
  struct Place {
    Vector x, y, z;
  };
  const auto load =
      [&](const auto& x, const auto& y, const auto& z, std::ptrdiff_t at) {
        return Place{hn::LoadU(floats, x.data() + at),
                     hn::LoadU(floats, y.data() + at),
                     hn::LoadU(floats, z.data() + at)};
      };
  const auto squareOf = [](const Place& p) {
    return hn::Add(hn::Add(hn::Mul(p.x, p.x), hn::Mul(p.y, p.y)), hn::Mul(p.z, p.z));
  };
  for (int i = 0; i < block; i += static_cast<int>(hn::Lanes(floats))) {
    const std::ptrdiff_t at = s.at(column, row) + i;
    const Place own = load(s.cx, s.cy, s.cz, at);
    Place sum = {hn::Zero(floats), hn::Zero(floats), hn::Zero(floats)};
    for (int down = -1; down <= 1; ++down)
      for (int right = -1; right <= 1; ++right) {
        const std::ptrdiff_t there = at + down * s.stride + right;
        const Place p = load(s.cx, s.cy, s.cz, there);
        const Place n = load(normals.x, normals.y, normals.z, there);
        const Place d = {hn::Sub(p.x, own.x), hn::Sub(p.y, own.y), hn::Sub(p.z, own.z)};
        const auto counts = hn::And(hn::Le(squareOf(d), hn::Set(floats, limit)),
                                    hn::Eq(n.x, n.x)); // not NaN
        // 4 in the center, 2 beside it, 1 at the corners.
        const Vector weight = hn::Set(
            floats, static_cast<float>((2 - std::abs(right)) * (2 - std::abs(down))));
        sum.x = hn::Add(sum.x, hn::IfThenElseZero(counts, hn::Mul(weight, n.x)));
        sum.y = hn::Add(sum.y, hn::IfThenElseZero(counts, hn::Mul(weight, n.y)));
        sum.z = hn::Add(sum.z, hn::IfThenElseZero(counts, hn::Mul(weight, n.z)));
      }
    const Place here = load(normals.x, normals.y, normals.z, at);
    const Vector length = hn::Sqrt(squareOf(sum));
    const auto known =
        hn::And(hn::Eq(here.x, here.x), hn::Gt(length, hn::Zero(floats)));
    const auto store = [&](Vector total, Vector before, float* to) {
      hn::StoreU(
          hn::IfThenElse(known, hn::Div(total, length), before), floats, to + at);
    };
    store(sum.x, here.x, out.x.data());
    store(sum.y, here.y, out.y.data());
    store(sum.z, here.z, out.z.data());
  }
}

} // namespace HWY_NAMESPACE
} // namespace linelet::screen
HWY_AFTER_NAMESPACE();

#endif
