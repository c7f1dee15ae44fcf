// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/usable_points.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief How to look for power lines. Lengths in meters. */
struct PowerLineSettings {
  bool use_classes =
      false;             ///< take the terrain from points of class 2, if there are any
  double clearance = 5;  ///< smallest acceptable distance to anything near a wire
  double max_gap = 50;   ///< no wire is extended across a longer stretch without points
  double min_height = 3; ///< wires hang at least this high above the terrain
  double min_length = 10; ///< shorter wires are reported only where the data ends or as
                          ///< visible parts of service drops
  io::ClassFilter points; ///< points of a cloud to use
  unsigned threads = 0;   ///< 0: all
};

/** \brief Names and meaning of the settings (see apps/options.h). */
template <class Visit>
void
describe(PowerLineSettings& s, Visit&& visit)
{
  visit("use-classes",
        s.use_classes,
        "take the terrain from points of class 2 where there are any");
  visit("clearance", s.clearance, "smallest acceptable clearance, meters");
  visit("max-gap", s.max_gap, "longest gap across which a wire is extended, meters");
  visit("min-height", s.min_height, "minimum height of wires above ground, meters");
  visit("min-length",
        s.min_length,
        "shortest wire to report, meters; shorter ones are reported where the data "
        "ends or they lead to a house");
}

} // namespace powerline
} // namespace linelet
