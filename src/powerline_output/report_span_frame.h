// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>

#include "report_page.h"

namespace linelet::powerline::report {

/** \brief Axis of a span in plan: from the middle of its wires' front ends to that of
 * their back ends. Needs at least one wire. */
class SpanFrame {
public:
  SpanFrame(const Content& content, const Span& span)
  {
    Point back = Point::Zero();
    for (const int id : span.wires) {
      from_ += content.wire(id).front / static_cast<double>(span.wires.size());
      back += content.wire(id).back / static_cast<double>(span.wires.size());
    }
    axis_ = back - from_;
    axis_.z() = 0;
    length = axis_.norm();
    axis_ = length > 1e-9 ? Point(axis_ / length) : Point(Point::UnitX());
    for (const int id : span.wires)
      for (const Point& end : {content.wire(id).front, content.wire(id).back})
        half_width = std::max(half_width, std::abs(across(end)));
  }

  double
  along(const Point& p) const
  {
    return (p.x() - from_.x()) * axis_.x() + (p.y() - from_.y()) * axis_.y();
  }

  double
  across(const Point& p) const
  {
    return (p.y() - from_.y()) * axis_.x() - (p.x() - from_.x()) * axis_.y();
  }

  Point
  at(double s) const
  {
    return from_ + s * axis_;
  }

  double length = 0;     ///< meters
  double half_width = 0; ///< largest distance of the wires' ends from the axis, meters

private:
  Point from_ = Point::Zero(), axis_ = Point::UnitX();
};

} // namespace linelet::powerline::report
