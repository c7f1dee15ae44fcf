// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "corridor_scene.h"
#include "plan_cells.h"

namespace linelet::bench::corridor {

/** \brief A beam: from the sensor along a unit direction. */
struct Ray {
  Point origin, direction;

  Point
  at(double t) const
  {
    return origin + t * direction;
  }
};

/** \brief Something a beam meets on its way. */
struct Hit {
  double t; ///< meters along the ray
  std::uint8_t classification;
  float reflectivity;
  double fraction; ///< share of the beam's cross-section that is covered
  std::int32_t wire;
};

/** \brief Finds what beams hit: the scene's objects in plan cells. */
class RayCaster {
public:
  /** \param[in] beam radius of a beam at the objects, meters */
  RayCaster(const Scene& scene, double beam);

  /** \brief All hits of a beam, nearest first, down to the terrain as the last one. */
  const std::vector<Hit>&
  cast(const Ray& ray, Random& random);

  /** \brief Height above which there is nothing. */
  double
  top() const
  {
    return top_;
  }

private:
  void
  insert(std::uint32_t id, const Point& low, const Point& high);
  void
  meet(std::uint32_t id, const Ray& ray, Random& random);
  void
  meetMember(const Member& member, const Ray& ray);
  void
  meetPanel(const Panel& panel, const Ray& ray);
  void
  meetCrown(const Crown& crown, const Ray& ray, Random& random);
  double
  terrainAlong(const Ray& ray) const;

  const Scene& scene_;
  double beam_, top_ = 0;
  Point low_, high_; ///< bounds of all things, in plan
  PlanCells cells_;
  std::vector<std::uint32_t> seen_; ///< number of the ray that last hit an object
  std::uint32_t ray_ = 0;
  std::vector<Hit> hits_;
};

} // namespace linelet::bench::corridor
