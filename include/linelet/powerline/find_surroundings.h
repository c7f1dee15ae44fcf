// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>
#include <linelet/io/usable_points.h>
#include <linelet/powerline/clearance_limits.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline/surroundings.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief The meaning of a file's classes, by default those of ASPRS. */
struct SurroundingClasses {
  io::ClassList vegetation{"3,4,5"};
  io::ClassList buildings{"6,17"};
};

template <class Visit>
void
describe(SurroundingClasses& s, Visit&& visit)
{
  visit("vegetation-classes", s.vegetation, "Hazards: classes of trees and bushes");
  visit("building-classes", s.buildings, "Hazards: classes of buildings and bridges");
}

/** \brief Collects what stands near the wires of \a network.
 *
 * Points of \a classes are what these say. All others (0, 1 and any class not named
 * here) are told apart by shape and returns: roofs and walls are planar over some
 * meters and give single echoes, masts and booms are linear there, undetected wires are
 * linear too and left out, and the rest is vegetation; fewer than four such points
 * within a meter of each other are a bird or noise. Points of the classes 2, 7, 8, 9,
 * 11, 13 to 16 and 18 are none of them, nor is anything but a building at the bodies,
 * arms and insulators of the supports of a wire.
 * \param[in] cloud what the network was extracted from
 * \param[in] usable its usable points
 * \param[in] limits the largest of which determines what is near
 * \throws Canceled */
Surroundings
findSurroundings(const PowerLineNetwork& network,
                 const io::Cloud& cloud,
                 const io::UsablePoints& usable,
                 const ClearanceLimits& limits,
                 const SurroundingClasses& classes = {},
                 unsigned threads = 0,
                 const ProgressMonitor* monitor = nullptr);

} // namespace powerline
} // namespace linelet
