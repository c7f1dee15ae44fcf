// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief Removes unfinished files that killed processes on this machine left in \a
 * folder. */
void
removeLeftovers(const std::string& folder);

/** \brief Removes all files under construction, by any writer; none is created or
 * published afterwards. For a program about to exit, from any thread. */
void
removeUnfinishedFiles();

} // namespace io
} // namespace linelet
