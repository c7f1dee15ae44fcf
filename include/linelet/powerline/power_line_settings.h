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
      false;            ///< take the terrain from points of class 2, where they exist
  double clearance = 5; ///< vegetation nearer than this is reported as a hazard
  double max_gap = 50; ///< no wire is carried on across a longer stretch without points
  double min_height = 3;  ///< wires hang higher above the terrain than this
  double min_length = 10; ///< a shorter wire is reported only where the data cut it
                          ///< off, or as what shows of a service drop
  io::ClassFilter points; ///< which of a cloud take part
  unsigned threads = 0;   ///< 0: all
};

/** \brief Names and meaning of the settings (see apps/options.h). */
template <class Visit>
void
describe(PowerLineSettings& s, Visit&& visit)
{
  visit("use-classes",
        s.use_classes,
        "terrain from points of class 2 where there are any");
  visit("clearance", s.clearance, "smallest clearance that is in order, meters");
  visit("max-gap", s.max_gap, "never carry a wire on across a longer gap, meters");
  visit("min-height", s.min_height, "wires hang higher above ground than this, meters");
  visit("min-length",
        s.min_length,
        "shortest wire to report, meters; shorter where the data end or it leads to a "
        "house");
}

} // namespace powerline
} // namespace linelet
