// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "report_section.h"

namespace linelet::powerline::report {

/** \brief What comes too close to the wires as scanned: stretches, trees that could
 * fall in, crossings, limits. Needs hazards. */
Section
hazardsSection(const Content& content);

/** \brief The same for every other state of the conductors, and the change of their
 * tensions. */
Section
statesSection(const Content& content);

} // namespace linelet::powerline::report
