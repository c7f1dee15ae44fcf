// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>

#include "io/file_work.h"

namespace linelet::io {

/** \brief The points as an unstructured grid of VTKHDF 1.0, for ParaView.
 *
 * \throws FileError, Canceled */
void
writeVtkHdf(const Target& target, const Cloud& cloud);

} // namespace linelet::io
