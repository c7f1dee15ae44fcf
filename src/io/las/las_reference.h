// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "las_format.h"

namespace linelet::io {

/** \brief The reference system stated in the records of \a origin, as WKT; empty if
 * there is none. \a problem: why a stated one cannot be used. */
std::string
lasReferenceSystem(const LasOrigin& origin, std::string& problem);

} // namespace linelet::io
