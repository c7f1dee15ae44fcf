// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>

#include <linelet/powerline/power_line_network.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief Whether a clearance of \a wire, to the ground or to vegetation, is known and
 * below \a limit. */
bool
belowClearance(const Wire& wire, double limit);

/** \brief Whether there are wires, but neither ground nor an object was seen near any
 * of them, so that no clearance is known. */
bool
clearancesAreUnknown(const PowerLineNetwork& network);

/** \brief How many wires fall below \a limit; empty if clearances are unknown, which 0
 * would misreport. */
std::optional<std::size_t>
wiresBelowClearance(const PowerLineNetwork& network, double limit);

} // namespace powerline
} // namespace linelet
