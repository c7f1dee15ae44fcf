// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <linelet/curves/curve_network.h>
#include <linelet/support/points.h>

namespace linelet::bench {

/** \brief The curves of a network laid end to end and parameterized by arc length. */
class NetworkArc {
public:
  explicit NetworkArc(const CurveNetwork& network)
  {
    for (const Curve& curve : network.curves) {
      const std::size_t count = curve.points.size();
      for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i)
        add(curve.points[i], curve.points[(i + 1) % count]);
    }
  }

  /** \brief The point at \a t in [0, 1]. */
  Point
  at(double t) const
  {
    const double s = t * end_.back();
    const auto found = std::upper_bound(end_.begin(), end_.end(), s);
    const auto i =
        std::min(static_cast<std::size_t>(found - end_.begin()), end_.size() - 1);
    const double begin = i == 0 ? 0 : end_[i - 1];
    return from_[i] + (to_[i] - from_[i]) * ((s - begin) / (end_[i] - begin));
  }

private:
  void
  add(const Point& a, const Point& b)
  {
    from_.push_back(a);
    to_.push_back(b);
    end_.push_back((end_.empty() ? 0 : end_.back()) + (b - a).norm());
  }

  Points from_, to_;
  std::vector<double> end_; // arc position of to_
};

} // namespace linelet::bench
