// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

#include <linelet/curves/curve_network.h>
#include <linelet/support/points.h>

namespace linelet::apps {

/** \brief How far curves may move when vertices are removed: a length, or "auto", a
 * tenth of each curve's measured noise (none where that is unknown). */
class SimplifyTolerance {
public:
  /** \throws std::invalid_argument unless "auto" or a number >= 0 */
  explicit SimplifyTolerance(std::string_view text);

  const std::string&
  name() const
  {
    return text_;
  }

  /** \brief The length for \a curve; 0: leave it unchanged. */
  double
  of(const Curve& curve) const;

private:
  std::string text_;
  double length_ = -1; // negative: from the noise
};

/** \brief The curves with as few vertices as Douglas and Peucker's algorithm
 * (Cartographica 10, 1973) leaves within their tolerance. Ends and junctions are
 * kept. */
CurveNetwork
simplified(CurveNetwork network, const SimplifyTolerance& tolerances);

} // namespace linelet::apps
