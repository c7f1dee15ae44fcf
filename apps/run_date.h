// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace linelet::apps {

/** \brief Now, in UTC, for readers: "2026-11-22 09:46 UTC". Where the environment gives
 * SOURCE_DATE_EPOCH (seconds since 1970, reproducible-builds.org), that instead. */
std::string
runDate();

} // namespace linelet::apps
