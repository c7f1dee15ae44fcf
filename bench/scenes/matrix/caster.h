// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <bench/scenes/plan_cells.h>

#include "world.h"

namespace linelet::bench::scenes {

/** \brief A pulse: from high above along a unit direction down to a known ground
 * point. */
struct Pulse {
  Point origin, direction;
  double ground; ///< where it reaches the terrain, meters along it

  Point
  at(double t) const
  {
    return origin + t * direction;
  }
};

/** \brief Something hit by a pulse. */
struct Hit {
  double t; ///< meters along the pulse
  Point place;
  double cover; ///< share of the pulse's energy that it takes
  std::uint8_t classification;
  std::int32_t wire;
};

/** \brief Finds what pulses hit: the world's objects in plan cells. */
class Caster {
public:
  Caster(const World& world, std::uint32_t seed);

  /** \brief All hits above the ground, nearest first. */
  const std::vector<Hit>&
  cast(const Pulse& pulse, Random& random);

  /** \brief Height of the highest thing. */
  double
  top() const
  {
    return high_.z();
  }

private:
  void
  insert(std::uint32_t id, const Point& low, const Point& high);
  void
  meetRod(const Rod& rod, const Pulse& pulse, Random& random);
  void
  meetFacet(const Facet& facet, const Pulse& pulse);
  void
  meetCrown(const Crown& crown, const Pulse& pulse, Random& random);

  const World& world_;
  std::uint32_t seed_;
  Point low_, high_; ///< bounds of all things
  PlanCells cells_;
  std::vector<std::uint32_t> seen_; ///< number of the pulse that last hit an object
  std::uint32_t pulse_ = 0;
  std::vector<Hit> hits_;
};

} // namespace linelet::bench::scenes
