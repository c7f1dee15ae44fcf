// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Only sums of integers are fused or reordered: all instruction sets give the
// same bits.

#include "box_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "set_bits.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "clustering/box_kernels.cpp"
#include <hwy/foreach_target.h> // includes this file once per instruction set

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linelet::clustering {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using Vector = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;
constexpr Doubles doubles;

/** \brief Calls work(place, pointer to lanes points), the last points filled up with
 * NaN. */
template <class Work>
inline void
forVectors(const Point* points, std::size_t count, const Work& work)
{
  const std::size_t lanes = hn::Lanes(doubles);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
    work(i, points[i].data());
  if (i == count)
    return;
  double rest[3 * PointBlock::margin];
  std::fill(std::begin(rest), std::end(rest), std::numeric_limits<double>::quiet_NaN());
  std::copy(points[i].data(), points[i].data() + 3 * (count - i), rest);
  work(i, rest);
}

void
extend(const Point* points, std::size_t count, const Corners& corners)
{
  const Vector infinite = hn::Set(doubles, std::numeric_limits<double>::infinity());
  Vector low[3] = {infinite, infinite, infinite};
  Vector high[3] = {hn::Neg(infinite), hn::Neg(infinite), hn::Neg(infinite)};
  forVectors(points, count, [&](std::size_t, const double* from) {
    Vector at[3];
    hn::LoadInterleaved3(doubles, from, at[0], at[1], at[2]);
    const Mask finite =
        hn::And(hn::IsFinite(at[0]), hn::And(hn::IsFinite(at[1]), hn::IsFinite(at[2])));
    for (int a = 0; a < 3; ++a) {
      low[a] = hn::Min(low[a], hn::IfThenElse(finite, at[a], infinite));
      high[a] = hn::Max(high[a], hn::IfThenElse(finite, at[a], hn::Neg(infinite)));
    }
  });
  for (int a = 0; a < 3; ++a) {
    corners.low[a] =
        std::min(corners.low[a], hn::GetLane(hn::MinOfLanes(doubles, low[a])));
    corners.high[a] =
        std::max(corners.high[a], hn::GetLane(hn::MaxOfLanes(doubles, high[a])));
  }
}

/** \brief One axis of the grid. */
struct Axis {
  Axis(const CellFrame& frame, int axis)
      : low(hn::Set(doubles, frame.low[axis])),
        size(hn::Set(doubles, frame.size[axis])),
        inverse(hn::Set(doubles, frame.inverse[axis])),
        last(hn::Set(doubles, frame.cells[static_cast<std::size_t>(axis)] - 1)),
        bricks(hn::Set(doubles, (frame.cells[static_cast<std::size_t>(axis)] + 7) / 8)),
        many(frame.cells[static_cast<std::size_t>(axis)] > 1)
  {
  }

  /** \brief The cell of coordinates along this axis, and where in it they are. */
  Vector
  cellOf(Vector at, Mask& inside, Vector& part) const
  {
    at = hn::Mul(hn::Sub(at, low), inverse);
    inside = hn::And(
        inside,
        hn::And(hn::Ge(at, hn::Zero(doubles)), hn::Lt(at, hn::Set(doubles, 1e9))));
    const Vector cell = hn::Min(hn::Trunc(hn::IfThenElseZero(inside, at)), last);
    part = many ? hn::Sub(at, cell) : hn::Set(doubles, 0.5);
    return cell;
  }

  /** \brief CellOrigin::middle of cells. */
  Vector
  middleOf(Vector cell) const
  {
    const Vector half = hn::Set(doubles, 0.5);
    return hn::Add(low, hn::Mul(hn::Add(cell, half), size));
  }

  Vector low, size, inverse, last, bricks;
  bool many;
};

/** \brief \ref nearestFace. */
struct Faces {
  explicit Faces(double width)
      : border(hn::Set(doubles, width)), step_scale(hn::Set(doubles, steps / width))
  {
  }

  Vector
  nearest(const Vector part[3], Mask inside) const
  {
    const Vector zero = hn::Zero(doubles), half = hn::Set(doubles, 0.5);
    Vector farthest = hn::Set(doubles, -1), face = zero;
    for (int a = 0; a < 3; ++a) {
      const Vector from = hn::Sub(part[a], half);
      const Mask farther = hn::Gt(hn::Abs(from), farthest);
      farthest = hn::IfThenElse(farther, hn::Abs(from), farthest);
      const Vector side = hn::IfThenElse(
          hn::Gt(from, zero), hn::Set(doubles, 2 * a + 1), hn::Set(doubles, 2 * a));
      face = hn::IfThenElse(farther, side, face);
    }
    const Vector distance = hn::Sub(half, farthest);
    const Vector step = hn::Min(hn::Trunc(hn::Max(hn::Mul(distance, step_scale), zero)),
                                hn::Set(doubles, steps - 1));
    return hn::IfThenElse(
        hn::And(inside, hn::Lt(distance, border)),
        hn::Add(hn::Mul(face, hn::Set(doubles, static_cast<double>(steps))), step),
        hn::Set(doubles, inside_cell));
  }

  Vector border, step_scale;
};

/** \brief CellDirectory::keyOf; all numbers are far below 2^53. */
inline Vector
keyOf(const Axis axes[3], const Vector cell[3])
{
  const Vector eight = hn::Set(doubles, 8);
  Vector brick[3], within[3];
  for (int a = 0; a < 3; ++a) {
    brick[a] = hn::Trunc(hn::Mul(cell[a], hn::Set(doubles, 0.125)));
    within[a] = hn::NegMulAdd(brick[a], eight, cell[a]);
  }
  const Vector row = hn::MulAdd(brick[2], axes[1].bricks, brick[1]);
  const Vector number = hn::MulAdd(row, axes[0].bricks, brick[0]);
  const Vector inside =
      hn::MulAdd(hn::MulAdd(within[2], eight, within[1]), eight, within[0]);
  return hn::MulAdd(
      number, hn::Set(doubles, double{CellDirectory::brick_cells}), inside);
}

/** \brief Calls finish(place, coordinates, cells, parts, located or not). */
template <class Finish>
inline void
locateAnd(const CellFrame& frame,
          const Point* points,
          int count,
          PointBlock& block,
          const Finish& finish)
{
  const Axis axes[3] = {{frame, 0}, {frame, 1}, {frame, 2}};
  block.count = count;
  forVectors(
      points, static_cast<std::size_t>(count), [&](std::size_t i, const double* from) {
        Vector at[3], part[3], cell[3];
        hn::LoadInterleaved3(doubles, from, at[0], at[1], at[2]);
        Mask inside = hn::Eq(axes[0].low, axes[0].low);
        for (int a = 0; a < 3; ++a)
          cell[a] = axes[a].cellOf(at[a], inside, part[a]);
        hn::StoreU(hn::IfThenElse(inside,
                                  keyOf(axes, cell),
                                  hn::Set(doubles, PointBlock::nowhere)),
                   doubles,
                   block.key + i);
        finish(i, at, cell, part, inside);
      });
}

void
locate(const CellFrame& frame, const Point* points, int count, PointBlock& block)
{
  locateAnd(frame,
            points,
            count,
            block,
            [](std::size_t, const Vector*, const Vector*, const Vector*, Mask) {});
}

/** \brief Offsets from the middles of cells. */
struct Offsets {
  Offsets(const CellFrame& frame, int bits) : axes{{frame, 0}, {frame, 1}, {frame, 2}}
  {
    for (int a = 0; a < 3; ++a)
      scale[a] = hn::Set(doubles, std::ldexp(1 / frame.size[a], bits));
  }

  void
  store(std::size_t i, const Vector* at, const Vector* cell, PointBlock& block) const
  {
    for (int a = 0; a < 3; ++a)
      hn::StoreU(
          hn::Round(hn::Mul(hn::Sub(at[a], axes[a].middleOf(cell[a])), scale[a])),
          doubles,
          block.offset[a] + i);
  }

  Axis axes[3];
  Vector scale[3];
};

void
locateMembers(
    const CellFrame& frame, int bits, const Point* points, int count, PointBlock& block)
{
  const Offsets offsets(frame, bits);
  locateAnd(
      frame,
      points,
      count,
      block,
      [&](std::size_t i, const Vector* at, const Vector* cell, const Vector*, Mask) {
        offsets.store(i, at, cell, block);
      });
}

void
locateWithFaces(const CellFrame& frame,
                int bits,
                double border,
                const Point* points,
                int count,
                PointBlock& block)
{
  const Offsets offsets(frame, bits);
  const Faces faces_of(border);
  const hn::Rebind<std::int32_t, Doubles> integers;
  locateAnd(frame,
            points,
            count,
            block,
            [&](std::size_t i,
                const Vector* at,
                const Vector* cell,
                const Vector* part,
                Mask inside) {
              offsets.store(i, at, cell, block);
              hn::StoreU(hn::DemoteTo(integers, faces_of.nearest(part, inside)),
                         integers,
                         block.face + i);
            });
}

void
findRuns(PointBlock& block)
{
  const int lanes = static_cast<int>(hn::Lanes(doubles));
  std::size_t runs = 0;
  if (block.count > 0)
    block.starts[runs++] = 0;
  for (int i = 0; i + 1 < block.count; i += lanes) {
    const Mask change =
        hn::And(hn::Ne(hn::LoadU(doubles, block.key + i),
                       hn::LoadU(doubles, block.key + i + 1)),
                hn::FirstN(doubles, static_cast<std::size_t>(block.count - 1 - i)));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(doubles, change, bits);
    // No branch for a change of cell: in fine grids it would be unpredictable.
    std::uint64_t places = 0;
    std::memcpy(&places, set_bits.places[bits[0]], sizeof(places));
    places += 0x0101010101010101U * static_cast<std::uint64_t>(i + 1);
    std::memcpy(block.starts + runs, &places, sizeof(places));
    runs += hn::CountTrue(doubles, change);
  }
  block.runs = static_cast<int>(runs);
}

void
add(const PointBlock& block, int first, int count, CellSums& sums)
{
  const Vector zero = hn::Zero(doubles);
  Vector x = zero, y = zero, z = zero;
  Vector xx = zero, xy = zero, xz = zero, yy = zero, yz = zero, zz = zero;
  const int lanes = static_cast<int>(hn::Lanes(doubles));
  for (int i = 0; i < count; i += lanes) {
    const Mask these = hn::FirstN(doubles, static_cast<std::size_t>(count - i));
    const auto offset = [&](int a) {
      return hn::IfThenElseZero(these, hn::LoadU(doubles, block.offset[a] + first + i));
    };
    const Vector u = offset(0), v = offset(1), w = offset(2);
    x = hn::Add(x, u);
    y = hn::Add(y, v);
    z = hn::Add(z, w);
    xx = hn::MulAdd(u, u, xx);
    xy = hn::MulAdd(u, v, xy);
    xz = hn::MulAdd(u, w, xz);
    yy = hn::MulAdd(v, v, yy);
    yz = hn::MulAdd(v, w, yz);
    zz = hn::MulAdd(w, w, zz);
  }
  const auto total = [](Vector part) {
    return static_cast<std::int64_t>(hn::GetLane(hn::SumOfLanes(doubles, part)));
  };
  sums.count += count;
  sums.first[0] += total(x);
  sums.first[1] += total(y);
  sums.first[2] += total(z);
  sums.second[0] += total(xx);
  sums.second[1] += total(xy);
  sums.second[2] += total(xz);
  sums.second[3] += total(yy);
  sums.second[4] += total(yz);
  sums.second[5] += total(zz);
}

BoxKernels
kernels()
{
  return {extend, locate, locateMembers, locateWithFaces, findRuns, add};
}

} // namespace HWY_NAMESPACE
} // namespace linelet::clustering
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace linelet::clustering {

HWY_EXPORT(kernels);

BoxKernels
boxKernels()
{
  static const BoxKernels chosen = HWY_DYNAMIC_DISPATCH(kernels)();
  return chosen;
}

} // namespace linelet::clustering

#endif
