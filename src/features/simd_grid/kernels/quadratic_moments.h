// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <linelet/tensor/weighting.h>

#include "features/simd_grid/order/point_list.h"

namespace linelet::grid {

/** \brief A weighting a + b x^2. */
struct QuadraticWeight {
  double a, b;
};

/** \brief The weighting as a polynomial in the squared distance, if it is one. */
inline std::optional<QuadraticWeight>
quadraticWeight(const Weighting& weighting)
{
  switch (weighting.kernel()) {
  case Kernel::Quadratic:
    return QuadraticWeight{1, -1};
  case Kernel::Epanechnikov:
    return QuadraticWeight{0.75, -0.75};
  default:
    return std::nullopt;
  }
}

/** \brief Sums over points p of 1, p and p (x) p, weighted by 1, each coordinate of p,
 * and |p|^2: the moments of any query follow from these if weights are polynomials of
 * squared distance, as a + b |p - q|^2 = a + b |q|^2 - 2 b q.p + b |p|^2. */
struct QuadraticMoments {
  Moments one, x, y, z, square;

  QuadraticMoments&
  operator+=(const QuadraticMoments& other)
  {
    one += other.one;
    x += other.x;
    y += other.y;
    z += other.z;
    square += other.square;
    return *this;
  }

  /** \brief Moments weighted by a + b |p - \a q|^2, about the origin. */
  Moments
  weighted(double a, double b, const Point& q) const
  {
    Moments m = one.times(a + b * q.squaredNorm());
    m += x.times(-2 * b * q.x());
    m += y.times(-2 * b * q.y());
    m += z.times(-2 * b * q.z());
    m += square.times(b);
    return m;
  }

  /** \brief The same sums of p - \a origin. */
  QuadraticMoments
  relativeTo(const Point& origin) const
  {
    const auto coordinate = [&](Moments m, double o) {
      m += one.times(-o);
      return m.relativeTo(origin);
    };
    return {one.relativeTo(origin),
            coordinate(x, origin.x()),
            coordinate(y, origin.y()),
            coordinate(z, origin.z()),
            weighted(0, 1, origin).relativeTo(origin)};
  }
};

} // namespace linelet::grid
