// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>

#include "io/file_work.h"

namespace linelet::io {

/** \brief The points as a fiber bundle.
 *
 * \throws FileError, Canceled */
void
writeHdf5(const Target& target, const Cloud& cloud);

} // namespace linelet::io
