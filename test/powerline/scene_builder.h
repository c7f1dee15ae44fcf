// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstdint>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <linelet/support/points.h>

namespace linelet::test {

/** \brief A small scan put together from ideal parts. */
class SceneBuilder {
public:
  explicit SceneBuilder(std::uint32_t seed) : random_(seed) {}

  Points points;

  double
  uniform(double low, double high)
  {
    return boost::random::uniform_real_distribution<double>(low, high)(random_);
  }

  double
  normal(double deviation)
  {
    return deviation * boost::random::normal_distribution<double>()(random_);
  }

  /** \brief Ground at height 0 between two corners, \a density points per square
   * meter. */
  void
  ground(double x0, double y0, double x1, double y1, double density)
  {
    box({x0, y0, -0.02}, {x1, y1, 0.02}, density * (x1 - x0) * (y1 - y0));
  }

  /** \brief \a count points spread evenly in a box. */
  void
  box(const Point& low, const Point& high, double count)
  {
    for (int i = 0; i < static_cast<int>(count); ++i)
      points.emplace_back(uniform(low.x(), high.x()),
                          uniform(low.y(), high.y()),
                          uniform(low.z(), high.z()));
  }

  /** \brief A wire from \a from to \a to with catenary parameter \a a, hanging straight
   * down, \a per_meter points with \a noise across it; nothing between \a gap_from and
   * \a gap_to (meters from its start). Positions follow the closed form. */
  void
  wire(const Point& from,
       const Point& to,
       double a,
       double per_meter,
       double noise,
       double gap_from = 0,
       double gap_to = 0)
  {
    const double length = (to - from).head<2>().norm();
    const auto count = static_cast<int>(length * per_meter);
    for (int i = 0; i < count; ++i) {
      const double s = uniform(0, length);
      if (s > gap_from && s < gap_to)
        continue;
      points.push_back(onWire(from, to, a, s) +
                       Point(normal(noise), normal(noise), normal(noise)));
    }
  }

  /** \brief The point \a s meters (in plan) from the start of a hanging wire. */
  static Point
  onWire(const Point& from, const Point& to, double a, double s)
  {
    // Through both ends: z = c + a cosh((s - s0) / a), s0 from the difference in
    // height.
    const double length = (to - from).head<2>().norm();
    const double s0 =
        length / 2 -
        a * std::asinh((to.z() - from.z()) / (2 * a * std::sinh(length / (2 * a))));
    const double z = from.z() + a * (std::cosh((s - s0) / a) - std::cosh(s0 / a));
    const Point p = from + s / length * (to - from);
    return {p.x(), p.y(), z};
  }

  /** \brief A lattice pylon of height \a height: four legs that lean inward. */
  void
  pylon(const Point& base, double height, double per_meter = 12)
  {
    for (int i = 0; i < static_cast<int>(height * per_meter); ++i) {
      const double z = uniform(0, height);
      const double w = 2.5 * (1 - z / height) + 0.3;
      points.push_back(
          base + Point(uniform(0, 1) < 0.5 ? -w : w, uniform(0, 1) < 0.5 ? -w : w, z));
    }
  }

private:
  boost::random::mt19937 random_;
};

} // namespace linelet::test
