// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "report_page.h"

namespace linelet::powerline::report {

/** \brief The lines seen from above, to scale, over a picture of the cloud. */
void
addPlan(Markup& page, const Content& content);

} // namespace linelet::powerline::report
