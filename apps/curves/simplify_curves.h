// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

#include <linelet/curves/curve_network.h>
#include <linelet/support/points.h>

namespace linelet::apps {

/** \brief How far vertices may be moved off curves to have fewer: a length, or "auto",
 * a tenth of the noise that each curve was measured with (none where it is unknown). */
class SimplifyTolerance {
public:
  /** \throws std::invalid_argument unless "auto" or a number >= 0 */
  explicit SimplifyTolerance(std::string_view text);

  const std::string&
  name() const
  {
    return text_;
  }

  /** \brief The length for \a curve; 0: as it is. */
  double
  of(const Curve& curve) const;

private:
  std::string text_;
  double length_ = -1; // negative: by the noise
};

/** \brief The curves with the fewest of their vertices that Douglas and Peucker's
 * algorithm leaves within their tolerance (Cartographica 10, 1973). Ends and
 * places where curves meet stay. */
CurveNetwork
simplified(CurveNetwork network, const SimplifyTolerance& tolerances);

} // namespace linelet::apps
