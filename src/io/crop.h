// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>

#include "window.h"

namespace linelet::io {

/** \brief Keeps the points of \a cloud that are in \a window; all of them, finite or
 * not, if it is everything. */
void
crop(Cloud& cloud, const Window& window);

} // namespace linelet::io
