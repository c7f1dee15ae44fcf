// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <bench/scenes/random.h>
#include <linelet/support/points.h>

namespace linelet::bench::scenes {

/** \brief Smooth noise in [0, 1] with about one hill per unit: random values at the
 * corners of a unit grid, interpolated between them. */
double
smoothNoise(const Point& p, std::uint32_t seed);

/** \brief What a terrain looks like. */
struct ReliefPlan {
  double slope = 0;      ///< degrees, of the whole scene
  double direction = 0;  ///< of the rise, radians from x
  double hills = 5;      ///< height differences within some hundred meters
  double rocks = 0;      ///< height of boulders
  double river_from = 0; ///< x of the banks; equal: no river
  double river_to = 0;
};

/** \brief Height of the ground and where it is water. */
class Relief {
public:
  Relief(const ReliefPlan& plan, Random& random);

  double
  height(double x, double y) const;
  bool
  water(double x, double y) const;

  Point
  at(double x, double y) const
  {
    return {x, y, height(x, y)};
  }

private:
  struct Wave {
    double kx, ky, phase, amplitude;
  };
  double
  bank(double x, double y) const;

  ReliefPlan plan_;
  double slope_x_, slope_y_;
  std::vector<Wave> waves_;
  std::uint32_t seed_;
};

} // namespace linelet::bench::scenes
