// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>

#include "io/file_work.h"

namespace linelet::io {

/** \throws FileError if no record can hold the attributes; Canceled */
void
writeLas(const Target& target, const Cloud& cloud);

/** \brief LAS with compressed points. */
void
writeLaz(const Target& target, const Cloud& cloud);

} // namespace linelet::io
