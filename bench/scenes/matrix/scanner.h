// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "world.h"

namespace linelet::bench::scenes {

/** \brief How a scene is scanned. */
struct ScanPlan {
  double density = 8; ///< pulses per square meter, all strips together
  double noise = 0.02;
  double altitude = 400;
  unsigned strips = 1;
  double misfit = 0;  ///< standard deviation of a strip's offset along an axis, meters
  double heading = 0; ///< of the flight, radians from x
};

/** \brief Scans \a world into \a scan, in the frame of the world. */
void
scan(const World& world,
     const ScanPlan& plan,
     Random& random,
     SceneScan& scan,
     ProgressMonitor* monitor);

} // namespace linelet::bench::scenes
