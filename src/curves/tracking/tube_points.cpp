// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tube_points.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "curves/tracking/tube_points.cpp"
#include <hwy/foreach_target.h> // includes this file once per instruction set

#include <hwy/highway.h>

#include <algorithm>

#include "support/append-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, TubePoints::padding>;
using V = hn::Vec<D>;

/** \brief The sum of squares or products as Eigen forms it: products are not fused with
 * sums, so that every instruction set gives the same bits. */
HWY_INLINE V
dot(const V (&a)[3], const V (&b)[3])
{
  return hn::Add(hn::Add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])),
                 hn::Mul(a[2], b[2]));
}

/** \brief Writes those of \a count points that lie in the tube; entries beyond them are
 * undefined. \return their number */
std::size_t
pointsInTube(const Tube& tube,
             const double* xyz,
             std::size_t count,
             std::uint64_t first,
             std::uint64_t* index,
             double* place,
             double* squared)
{
  const D d;
  const hn::RebindToUnsigned<D> u;
  const std::size_t lanes = hn::Lanes(d);
  V at[3], direction[3], curvature[3];
  for (int k = 0; k < 3; ++k) {
    at[k] = hn::Set(d, tube.at[k]);
    direction[k] = hn::Set(d, tube.direction[k]);
    curvature[k] = hn::Set(d, tube.curvature[k]);
  }
  const V length = hn::Set(d, tube.length), radius = hn::Set(d, tube.squared_radius);
  HWY_ALIGN double rest[3 * TubePoints::padding] = {};
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; i += lanes) {
    const double* from = xyz + 3 * i;
    if (count - i < lanes) {
      std::copy(from, xyz + 3 * count, rest);
      from = rest;
    }
    V v[3], off[3];
    hn::LoadInterleaved3(d, from, v[0], v[1], v[2]);
    for (int k = 0; k < 3; ++k)
      v[k] = hn::Sub(v[k], at[k]);
    const V along = dot(direction, v);
    const V half = hn::Mul(hn::Set(d, 0.5), along);
    for (int k = 0; k < 3; ++k)
      off[k] = hn::Sub(
          v[k], hn::Mul(along, hn::Add(direction[k], hn::Mul(half, curvature[k]))));
    const V away = dot(off, off);
    const auto inside = hn::And(
        hn::And(hn::Gt(along, hn::Zero(d)), hn::Le(along, length)),
        hn::And(hn::Le(away, radius), hn::FirstN(d, std::min(lanes, count - i))));
    if (hn::AllFalse(d, inside))
      continue;
    appendWide(u, hn::Iota(u, first + i), hn::RebindMask(u, inside), index + found);
    appendWide(d, along, inside, place + found);
    appendWide(d, away, inside, squared + found);
    found += hn::CountTrue(d, inside);
  }
  return found;
}

auto
kernelOfTubes()
{
  return &pointsInTube;
}

} // namespace HWY_NAMESPACE
} // namespace linelet
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace linelet {

HWY_EXPORT(kernelOfTubes);

void
appendPointsInTube(const Tube& tube,
                   const Points& points,
                   std::size_t begin,
                   std::size_t end,
                   TubePoints& found)
{
  static const auto kernel = HWY_DYNAMIC_DISPATCH(kernelOfTubes)();
  if (const std::size_t room = found.count + (end - begin) + TubePoints::padding;
      found.index.size() < room) {
    found.index.resize(2 * room);
    found.place.resize(2 * room);
    found.squared.resize(2 * room);
  }
  found.count += kernel(tube,
                        points[begin].data(),
                        end - begin,
                        begin,
                        found.index.data() + found.count,
                        found.place.data() + found.count,
                        found.squared.data() + found.count);
}

} // namespace linelet

#endif
