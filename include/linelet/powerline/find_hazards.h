// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/powerline/hazards.h>
#include <linelet/powerline/surroundings.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief Every stretch of a wire closer to something than its limit allows, all
 * crossings, and the trees that would reach a wire by falling.
 *
 * A stretch is the union of the parts of the wire that are closer than the limit to any
 * point of one kind; gaps of up to a meter are closed. Distances are measured in 3D to
 * the interpolated terrain, between the curves of wires, and to the points of
 * everything else.
 * \throws Canceled */
Hazards
findHazards(const PowerLineNetwork& network,
            const Surroundings& surroundings,
            const ClearanceLimits& limits,
            unsigned threads = 0,
            const ProgressMonitor* monitor = nullptr);

} // namespace powerline
} // namespace linelet
