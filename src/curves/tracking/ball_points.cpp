// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ball_points.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "curves/tracking/ball_points.cpp"
#include <hwy/foreach_target.h> // includes this file once per instruction set

#include <hwy/highway.h>

#include <algorithm>

#include "support/append-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/** \brief Writes those of \a count points that lie in the ball; entries beyond them are
 * undefined. \return their number */
std::size_t
pointsInBall(const double* middle,
             double squared_radius,
             const double* xyz,
             std::size_t count,
             std::uint64_t first,
             std::uint64_t* index,
             double* const* offset,
             double* squared)
{
  const hn::CappedTag<double, BallPoints::padding> d;
  const hn::RebindToUnsigned<decltype(d)> u;
  const std::size_t lanes = hn::Lanes(d);
  const auto mx = hn::Set(d, middle[0]), my = hn::Set(d, middle[1]),
             mz = hn::Set(d, middle[2]), radius = hn::Set(d, squared_radius);
  HWY_ALIGN double rest[3 * BallPoints::padding] = {};
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; i += lanes) {
    const double* from = xyz + 3 * i;
    if (count - i < lanes) {
      std::copy(from, xyz + 3 * count, rest);
      from = rest;
    }
    hn::Vec<decltype(d)> x, y, z;
    hn::LoadInterleaved3(d, from, x, y, z);
    x = hn::Sub(x, mx);
    y = hn::Sub(y, my);
    z = hn::Sub(z, mz);
    // Summed in the order of Eigen, without fused operations: every instruction set
    // gives the same bits.
    const auto away = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
    const auto inside =
        hn::And(hn::Le(away, radius), hn::FirstN(d, std::min(lanes, count - i)));
    if (hn::AllFalse(d, inside))
      continue;
    appendWide(u, hn::Iota(u, first + i), hn::RebindMask(u, inside), index + found);
    appendWide(d, x, inside, offset[0] + found);
    appendWide(d, y, inside, offset[1] + found);
    appendWide(d, z, inside, offset[2] + found);
    appendWide(d, away, inside, squared + found);
    found += hn::CountTrue(d, inside);
  }
  return found;
}

/** \brief As \ref countInCylinder. */
std::size_t
pointsInCylinder(const double* const* offset,
                 const double* squared,
                 std::size_t count,
                 const double* direction,
                 double squared_half,
                 double squared_radius)
{
  const hn::CappedTag<double, BallPoints::padding> d;
  const std::size_t lanes = hn::Lanes(d);
  const auto dx = hn::Set(d, direction[0]), dy = hn::Set(d, direction[1]),
             dz = hn::Set(d, direction[2]), half = hn::Set(d, squared_half),
             radius = hn::Set(d, squared_radius);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < count; i += lanes) {
    const auto along = hn::MulAdd(hn::LoadU(d, offset[0] + i),
                                  dx,
                                  hn::MulAdd(hn::LoadU(d, offset[1] + i),
                                             dy,
                                             hn::Mul(hn::LoadU(d, offset[2] + i), dz)));
    const auto away = hn::LoadU(d, squared + i);
    const auto near =
        hn::And(hn::Le(away, half), hn::Le(hn::NegMulAdd(along, along, away), radius));
    inside +=
        hn::CountTrue(d, hn::And(near, hn::FirstN(d, std::min(lanes, count - i))));
  }
  return inside;
}

auto
kernelOfBalls()
{
  return &pointsInBall;
}

auto
kernelOfCylinders()
{
  return &pointsInCylinder;
}

} // namespace HWY_NAMESPACE
} // namespace linelet
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace linelet {

HWY_EXPORT(kernelOfBalls);
HWY_EXPORT(kernelOfCylinders);

void
appendPointsInBall(const Point& middle,
                   double radius,
                   const Points& points,
                   std::size_t begin,
                   std::size_t end,
                   BallPoints& found)
{
  static const auto kernel = HWY_DYNAMIC_DISPATCH(kernelOfBalls)();
  if (const std::size_t room = found.count + (end - begin) + BallPoints::padding;
      found.index.size() < room) {
    found.index.resize(2 * room);
    for (std::vector<double>& axis : found.offset)
      axis.resize(2 * room);
    found.squared.resize(2 * room);
  }
  double* const offset[] = {found.offset[0].data() + found.count,
                            found.offset[1].data() + found.count,
                            found.offset[2].data() + found.count};
  found.count += kernel(middle.data(),
                        radius * radius,
                        points[begin].data(),
                        end - begin,
                        begin,
                        found.index.data() + found.count,
                        offset,
                        found.squared.data() + found.count);
}

std::size_t
countInCylinder(const BallPoints& points,
                const Point& direction,
                double squared_half,
                double squared_radius)
{
  static const auto kernel = HWY_DYNAMIC_DISPATCH(kernelOfCylinders)();
  const double* const offset[] = {
      points.offset[0].data(), points.offset[1].data(), points.offset[2].data()};
  return kernel(offset,
                points.squared.data(),
                points.count,
                direction.data(),
                squared_half,
                squared_radius);
}

} // namespace linelet

#endif
