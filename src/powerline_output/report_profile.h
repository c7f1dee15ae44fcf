// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "report_page.h"

namespace linelet::powerline::report {

/** \brief The profile of a span: wires, points, terrain, attachments, clearances. */
void
addProfile(Markup& page,
           const Content& content,
           const Span& span,
           const Indices& points);

} // namespace linelet::powerline::report
