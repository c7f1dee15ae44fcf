// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <utility>
#include <vector>

#include <linelet/powerline/power_line_network.h>

namespace linelet::powerline {

/** \brief A catenary prepared for many distance queries. */
class WireCurve {
public:
  explicit WireCurve(const Catenary& curve);

  double
  from() const
  {
    return from_;
  }
  double
  to() const
  {
    return to_;
  }

  Point
  at(double s) const;

  /** \brief s of the point of the wire nearest to \a p. */
  double
  nearest(const Point& p) const;

  /** \brief Ends of the part of the wire around \ref nearest that lies within
   * \a radius of \a p; empty (first > second) if there is none. */
  std::pair<double, double>
  within(const Point& p, double radius) const;

private:
  // In the plane of the curve: x along it, y up in it.
  double
  nearestAlong(double x, double y) const;

  Point lowest_, forward_, up_, across_;
  double a_, from_, to_;
};

/** \brief The curves of all wires, by id - 1. */
std::vector<WireCurve>
curvesOf(const std::vector<Wire>& wires);

} // namespace linelet::powerline
