// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>
#include <linelet/powerline/network_part.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline/power_line_settings.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief Extracts every wire from an airborne or UAV scan, without training or a map.
 *
 * Candidates above ground with a line-like neighborhood seed wires; a wire grows along
 * itself as a robustly fitted parabola (approximating a catenary) as long as the points
 * ahead stand out from those around them; it is broken at supports, accepted on
 * evidence, joined to its continuation, and fitted as a catenary. A network without
 * wires is a valid result.
 *
 * \param[in] points meters, z up; points that are not finite are ignored
 * \param[in] classes class of every point, or empty; gives the ground (2) with
 * PowerLineSettings::use_classes, and is kept for points that get no new class
 * \param[in] settings see there
 * \param[in] monitor notified of the stages; may cancel
 * \param[out] part if not null: what was found, for \ref mergeParts, if the points are
 * part of a larger cloud
 * \return wires, supports and a label for every point
 * \throws std::invalid_argument for a setting out of range, or if there are not as many
 * classes as points
 * \throws Canceled */
PowerLineNetwork
extractPowerLines(const Points& points,
                  const std::vector<std::uint8_t>& classes = {},
                  const PowerLineSettings& settings = {},
                  ProgressMonitor* monitor = nullptr,
                  NetworkPart* part = nullptr);

/** \brief The same for a cloud, whose column `classification` gives the classes.
 * Withheld points are ignored (io::UsablePoints). The network is in meters even if the
 * cloud is not: see MetricFrame.
 * \throws std::invalid_argument also if the cloud's units are not lengths */
PowerLineNetwork
extractPowerLines(const io::Cloud& cloud,
                  const PowerLineSettings& settings = {},
                  ProgressMonitor* monitor = nullptr,
                  NetworkPart* part = nullptr);

} // namespace powerline
} // namespace linelet
