// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <memory>
#include <vector>

#include <linelet/powerline/power_line_network.h>
#include <linelet/search/uniform_grid.h>

namespace linelet::powerline {

/** \brief An end of a wire at a support. Positions along it are in meters from the
 * attachment point into the span; negative ones lie beyond. */
struct WireEnd {
  const Wire* wire;
  bool front;
  double attachment;  ///< s of the catenary there
  double earthed = 0; ///< position where the structure ends and the string begins
  double clamp = 0;   ///< position where the jumper begins, if there is one
  bool clamped = false;

  Point
  at(double along) const
  {
    return wire->curve.at(front ? attachment + along : attachment - along);
  }

  double
  along(const Point& p) const
  {
    const double s = wire->curve.along(p) - attachment;
    return front ? s : -s;
  }

  /** \brief Horizontal, unit length, into the span. */
  Point
  outward() const
  {
    Point out = at(1) - at(0);
    out.z() = 0;
    return out.normalized();
  }
};

/** \brief The surroundings of one support, or of several that stand together, point by
 * point: what is bulky, and what hangs there. */
struct SupportSite {
  static constexpr int none = -1;
  static constexpr int other_wire = -2; ///< of none of \ref ends

  Point axis = Point::Zero();
  double radius = 0;         ///< in plan
  std::vector<int> supports; ///< ids
  std::vector<WireEnd> ends;
  std::map<int, int> end_of; ///< by the id of its wire, or of that wire's continuation
                             ///< if a string was taken for a span
  Points points;
  Indices input; ///< index of each in the input
  std::unique_ptr<UniformGrid> grid;
  Points direction; ///< of the thin body around a point; 0 if it is bulky
  std::vector<char>
      earthed;            ///< part of a structure, or of something else that is bulky
  std::vector<char> live; ///< connected to wires, and not earthed
  std::vector<int> tube;  ///< end of a wire in whose tube it lies
  std::vector<double> along; ///< place along that end

  /** \brief Whether it hangs and is not part of a known wire. */
  bool
  isLoose(Index i) const
  {
    return live[i] != 0 && tube[i] == none;
  }
};

/** \brief Groups the points that \a takes accepts, one group per body. Empty if there
 * are none. */
template <class Takes>
std::vector<Indices>
bodiesOf(const SupportSite& site, double link, Takes&& takes)
{
  std::vector<char> seen(site.points.size(), 0);
  std::vector<Indices> bodies;
  for (Index i = 0; i < site.points.size(); ++i) {
    if (seen[i] != 0 || !takes(i))
      continue;
    Indices body = {i};
    seen[i] = 1;
    for (std::size_t k = 0; k < body.size(); ++k)
      site.grid->forEachWithin(site.points[body[k]], link, [&](Index j, double) {
        if (seen[j] == 0 && takes(j)) {
          seen[j] = 1;
          body.push_back(j);
        }
      });
    bodies.push_back(std::move(body));
  }
  return bodies;
}

} // namespace linelet::powerline
