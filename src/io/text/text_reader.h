// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "io/source.h"

namespace linelet::io {

/** \brief Rows of numbers, with or without a line of names.
 *
 * \throws FileError, Canceled */
Cloud
readText(const Source& source);

} // namespace linelet::io
