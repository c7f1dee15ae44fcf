// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "report_section.h"

namespace linelet::powerline::report {

/** \brief Cloud and lines as a 3D view that can be rotated; a still picture in browsers
 * without WebGL 2. */
Section
spaceSection(const Content& content);

} // namespace linelet::powerline::report
