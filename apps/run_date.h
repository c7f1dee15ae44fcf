// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace linelet::apps {

/** \brief The current time in UTC, for readers: "2026-11-22 09:46 UTC"; or
 * SOURCE_DATE_EPOCH (seconds since 1970, reproducible-builds.org) if the environment
 * sets it. */
std::string
runDate();

} // namespace linelet::apps
