// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "world.h"

namespace linelet::evaluation::scenes {

/** \brief How a scene is scanned. */
struct ScanPlan {
  double density = 8; ///< pulses per square metre, all strips together
  double noise = 0.02;
  double altitude = 400;
  unsigned strips = 1;
  double misfit = 0;  ///< standard deviation of a strip's offset along an axis, metres
  double heading = 0; ///< of the flight, radians from x
};

/** \brief Scans \a world into \a scan, in the frame of the world. */
void
scan(const World& world,
     const ScanPlan& plan,
     Random& random,
     SceneScan& scan,
     Monitor* monitor);

} // namespace linelet::evaluation::scenes
