// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "io/source.h"

namespace linelet::io {

/** \brief The points of a LAS or LAZ file, or of some of its blocks (Source::first).
 *
 * \throws FileError, Canceled */
Cloud
readLas(const Source& source);

} // namespace linelet::io
